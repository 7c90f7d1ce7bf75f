//! Both broad phases called with the same lists, without a pipeline.
//!
//! Called from outside, Rapier's treats every listed collider as new, and keeps no margin. Without a margin, ours must
//! hold the same pairs, but for those that were reported and that the narrow phase has come to drop since: Rapier's keeps
//! them until their boxes part, and ours ends them. The two are not compared where one collider is removed and another gets
//! its index in the same update: there Rapier's may keep pairs of the removed one, and report their end later.

use super::*;

#[cfg(feature = "serde-serialize")]
#[path = "../../told/mod.rs"]
mod told;
#[cfg(feature = "serde-serialize")]
use told::told;

struct Driven {
    bodies: RigidBodySet,
    colliders: ColliderSet,
    islands: IslandManager,
    ours: UnisizeBroadPhase,
    theirs: BroadPhaseBvh,
    /// The pairs that theirs holds, by its events.
    held: BTreeSet<Pair>,
    live: Vec<ColliderHandle>,
    modified: Vec<ColliderHandle>,
    removed: Vec<ColliderHandle>,
    reported: usize,
}

impl Driven {
    fn new() -> Self {
        // Without margins, and with all pairs whose boxes overlap, as Rapier's own.
        let settings = Settings::default()
            .with_margin(0.0)
            .with_filter(PairFilter::Groups);
        Self {
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            islands: IslandManager::new(),
            ours: UnisizeBroadPhase::with_settings(settings),
            theirs: BroadPhaseBvh::new(),
            held: BTreeSet::new(),
            live: Vec::new(),
            modified: Vec::new(),
            removed: Vec::new(),
            reported: 0,
        }
    }

    fn insert(&mut self, random: &mut Rand32) {
        let collider = collider(random).translation(within(random, 4.0));
        let handle = match random.rand_range(0..4) {
            0 => self.colliders.insert(collider),
            1 if !self.bodies.is_empty() => {
                let count = self.bodies.len() as u32;
                let nth = random.rand_range(0..count) as usize;
                let (body, _) = self.bodies.iter().nth(nth).unwrap();
                self.colliders
                    .insert_with_parent(collider, body, &mut self.bodies)
            }
            _ => {
                let body = self.bodies.insert(body(random));
                self.colliders
                    .insert_with_parent(collider, body, &mut self.bodies)
            }
        };
        self.live.push(handle);
        self.modified.push(handle);
    }

    fn change(&mut self, random: &mut Rand32, may_remove: bool) {
        let nth = random.rand_range(0..self.live.len() as u32) as usize;
        let handle = self.live[nth];
        self.modified.push(handle);
        let other = collider(random).build();
        let mine = &mut self.colliders[handle];
        match random.rand_range(0..8) {
            0 => mine.set_collision_groups(other.collision_groups()),
            1 => mine.set_active_collision_types(other.active_collision_types()),
            2 => mine.set_sensor(other.is_sensor()),
            3 if may_remove => {
                self.live.swap_remove(nth);
                self.modified.retain(|&modified| modified != handle);
                self.removed.push(handle);
                let soft_bodies = &mut SoftBodySet::new();
                let (islands, bodies) = (&mut self.islands, &mut self.bodies);
                self.colliders
                    .remove(handle, islands, bodies, soft_bodies, false);
            }
            _ => {
                let there = mine.translation() + within(random, 1.0);
                mine.set_translation(there);
            }
        }
    }

    /// Updates both, and checks that they hold the same.
    fn update(&mut self) {
        self.modified
            .sort_unstable_by_key(|handle| handle.into_raw_parts());
        self.modified.dedup();
        let params = IntegrationParameters::default();
        let [mut ours, mut theirs] = [(); 2].map(|()| Vec::new());
        let mut before = pairs(&self.ours);
        let (colliders, bodies) = (&self.colliders, &self.bodies);
        let (modified, removed) = (&self.modified, &self.removed);
        self.ours
            .update(&params, colliders, bodies, modified, removed, &mut ours);
        self.theirs
            .update(&params, colliders, bodies, modified, removed, &mut theirs);
        let is_gone = |pair: &Pair| {
            let mut removed = removed.iter().map(|handle| handle.into_raw_parts());
            removed.any(|gone| pair.contains(&gone))
        };
        for held in [&mut before, &mut self.held] {
            held.retain(|pair| !is_gone(pair));
        }
        apply(&ours, &mut before);
        apply(&theirs, &mut self.held);
        let may_meet = |pair: &&Pair| may_meet(**pair, colliders, bodies);
        let expected: BTreeSet<_> = self.held.iter().filter(may_meet).copied().collect();
        assert_eq!(before, expected, "by events");
        assert_eq!(pairs(&self.ours), expected);
        self.reported += ours.len();
        self.ours.validate();
        self.modified.clear();
        self.removed.clear();
    }
}

/// Adds and removes pairs by events, each of which must make sense.
fn apply(events: &[BroadPhasePairEvent], held: &mut BTreeSet<Pair>) {
    for event in events {
        let is_due = match event {
            BroadPhasePairEvent::AddPair(pair) => held.insert(raw(pair.collider1, pair.collider2)),
            BroadPhasePairEvent::DeletePair(pair) => {
                held.remove(&raw(pair.collider1, pair.collider2))
            }
        };
        assert!(is_due, "an event is spurious, or comes twice");
    }
}

/// Plays random updates, and after each calls `between` with our broad phase.
fn play(between: impl Fn(&mut UnisizeBroadPhase)) {
    let mut reported = 0;
    for seed in 0..40 {
        let mut random = Rand32::new(seed);
        let mut driven = Driven::new();
        for _ in 0..60 {
            driven.insert(&mut random);
        }
        driven.update();
        for round in 0..40 {
            let may_remove = round % 2 == 0;
            for _ in 0..random.rand_range(0..20) {
                driven.change(&mut random, may_remove);
            }
            if !may_remove {
                for _ in 0..random.rand_range(0..4) {
                    driven.insert(&mut random);
                }
            }
            driven.update();
            between(&mut driven.ours);
        }
        reported += driven.reported;
    }
    assert!(reported > 1000, "only {reported} events");
}

#[test]
fn the_same_pairs() {
    play(|_| {});
}

#[cfg(feature = "serde-serialize")]
#[test]
fn the_same_pairs_after_it_was_written_and_read() {
    play(|ours| {
        let bytes = postcard::to_stdvec(ours).unwrap();
        let stats = ours.stats();
        *ours = postcard::from_bytes(&bytes).unwrap();
        assert_eq!(told(&ours.stats()), told(&stats));
        ours.validate();
    });
}

#[cfg(feature = "serde-serialize")]
#[test]
fn a_pair_that_may_not_meet_is_no_candidate() {
    let mut colliders = ColliderSet::new();
    let handles = [0.0, 0.5, 9.0]
        .map(|x| colliders.insert(ColliderBuilder::ball(0.5).translation(Vector::X * x)));
    let mut broad_phase = UnisizeBroadPhase::new();
    let params = IntegrationParameters::default();
    let bodies = RigidBodySet::new();
    broad_phase.update(&params, &colliders, &bodies, &handles, &[], &mut Vec::new());
    assert_eq!(broad_phase.stats().candidates, 0);
    let mut damaged = serde_json::to_value(&broad_phase).unwrap();
    damaged["table"]["tracker"]["near"] = serde_json::json!([[0, 1]]);
    let error = serde_json::from_value::<UnisizeBroadPhase>(damaged).unwrap_err();
    assert!(error.to_string().contains("near"), "{error}");
}

#[test]
fn what_is_taken_as_modified_is_listed_once_in_its_life() {
    let mut colliders = ColliderSet::new();
    let handle = colliders.insert(ColliderBuilder::ball(0.5));
    assert_eq!(colliders.take_modified().len(), 1);
    colliders[handle].set_translation(Vector::X);
    assert!(colliders.take_modified().is_empty());
}

#[test]
fn a_pair_begins_and_ends_with_what_allows_it_once_its_collider_is_listed() {
    let mut colliders = ColliderSet::new();
    let bodies = RigidBodySet::new();
    let handles = [(); 2].map(|()| colliders.insert(ColliderBuilder::ball(0.5)));
    let mut broad_phase = UnisizeBroadPhase::new();
    let mut update = |colliders: &ColliderSet, modified: &[ColliderHandle]| {
        let mut events = Vec::new();
        let params = IntegrationParameters::default();
        broad_phase.update(&params, colliders, &bodies, modified, &[], &mut events);
        let stats = broad_phase.stats();
        assert_eq!(broad_phase.pairs().count(), stats.pairs);
        (events.len(), stats.pairs)
    };
    // Without bodies they count as fixed.
    assert_eq!(update(&colliders, &handles), (0, 0));
    colliders[handles[1]].set_active_collision_types(ActiveCollisionTypes::all());
    assert_eq!(update(&colliders, &[]), (0, 0));
    assert_eq!(update(&colliders, &handles[1..]), (1, 1));
    colliders[handles[1]].set_active_collision_types(ActiveCollisionTypes::empty());
    assert_eq!(update(&colliders, &handles[..1]), (0, 1));
    assert_eq!(update(&colliders, &handles), (1, 0));
    colliders[handles[0]].set_active_collision_types(ActiveCollisionTypes::all());
    colliders[handles[0]].set_translation(Vector::X * 9.0);
    assert_eq!(update(&colliders, &handles), (0, 0));
    colliders[handles[0]].set_translation(Vector::ZERO);
    assert_eq!(update(&colliders, &handles), (1, 1));
}

#[test]
fn boxes_that_rapier_would_panic_at_have_no_loosening() {
    let mut colliders = ColliderSet::new();
    let bodies = RigidBodySet::new();
    let mut random = Rand32::new(1);
    let handles: Vec<_> = (0..40)
        .map(|i| {
            let skin = [-1.0, Real::NAN, Real::INFINITY, 0.0][i % 4];
            colliders.insert(collider(&mut random).contact_skin(skin))
        })
        .collect();
    let mut broad_phase = UnisizeBroadPhase::new();
    let params = IntegrationParameters::default();
    broad_phase.update(&params, &colliders, &bodies, &handles, &[], &mut Vec::new());
    broad_phase.validate();
    assert_eq!(broad_phase.stats().proxies, handles.len());
}

/// Two balls that touch, of which one has been moved on, and one that the broad phase does not know yet.
#[cfg(feature = "serde-serialize")]
fn with_boxes_handed_over() -> (ColliderSet, UnisizeBroadPhase) {
    let mut colliders = ColliderSet::new();
    let ball = || ColliderBuilder::ball(0.5).active_collision_types(ActiveCollisionTypes::all());
    let handles = [0.0, 0.9, 9.0].map(|x| colliders.insert(ball().translation(Vector::X * x)));
    let (mut ours, params) = (UnisizeBroadPhase::new(), IntegrationParameters::default());
    let mut events = Vec::new();
    let bodies = RigidBodySet::new();
    ours.update(
        &params,
        &colliders,
        &bodies,
        &handles[..2],
        &[],
        &mut events,
    );
    colliders[handles[1]].set_translation(Vector::X * 8.5);
    let boxes = [handles[1], handles[2]].map(|handle| {
        let aabb = colliders[handle].compute_broad_phase_aabb(&params, &bodies);
        (handle, aabb)
    });
    ours.set_aabbs(&params, &boxes);
    (colliders, ours)
}

#[cfg(feature = "serde-serialize")]
#[test]
fn boxes_handed_over_are_part_of_a_snapshot() {
    let (colliders, ours) = with_boxes_handed_over();
    let bytes = postcard::to_stdvec(&ours).unwrap();
    let restored: UnisizeBroadPhase = postcard::from_bytes(&bytes).unwrap();
    assert_eq!(told(&restored.stats()), told(&ours.stats()));
    for mut broad_phase in [ours.clone(), ours, restored] {
        broad_phase.validate();
        assert_eq!(broad_phase.stats().pairs, 1);
        let (params, bodies) = (IntegrationParameters::default(), RigidBodySet::new());
        let mut events = Vec::new();
        broad_phase.update(&params, &colliders, &bodies, &[], &[], &mut events);
        broad_phase.validate();
        let stats = broad_phase.stats();
        assert_eq!([stats.listed, stats.moved, stats.proxies], [2, 2, 3]);
        assert_eq!([stats.added, stats.deleted, events.len()], [1, 1, 2]);
    }
}

#[cfg(feature = "serde-serialize")]
#[test]
fn boxes_handed_over_in_a_snapshot_must_make_sense() {
    use serde_json::{Value, json};
    let (_, ours) = with_boxes_handed_over();
    let value = serde_json::to_value(&ours).unwrap();
    let complaint = |change: &dyn Fn(&mut Value)| {
        let mut damaged = value.clone();
        change(&mut damaged["table"]);
        assert_ne!(damaged["table"], value["table"], "nothing was changed");
        let outcome = serde_json::from_value::<UnisizeBroadPhase>(damaged);
        outcome.expect_err("it is accepted").to_string()
    };
    type Change = fn(&mut Value);
    let damages: [(&str, Change); 6] = [
        ("for no update", |table| {
            table["gathered"]["is_begun"] = json!(false)
        }),
        ("can be counted", |table| {
            table["gathered"]["listed"] = json!(1_u64 << 40)
        }),
        ("no collider", |table| table["awaited"] = json!([])),
        ("out of range", |table| {
            table["tracker"]["touched"][0][0] = json!(77)
        }),
        ("not valid", |table| {
            let aabb = &mut table["tracker"]["touched"][0][1];
            aabb["mins"][0] = json!(99.0);
        }),
        ("filter key", |table| {
            let key = table["tracker"]["proxies"][0]["key"].clone();
            table["tracker"]["other_keys"] = json!([[0, key]]);
        }),
    ];
    for (part, change) in damages {
        let said = complaint(&change);
        assert!(said.contains(part), "{said}");
    }
}
