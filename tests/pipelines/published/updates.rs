//! Single updates made by hand, and what a snapshot has of boxes that were handed over.

use super::*;

#[cfg(feature = "serde-serialize")]
#[path = "../../told/mod.rs"]
mod told;

/// What every update is given but for the lists, and a broad phase.
#[derive(Default)]
struct Desk {
    colliders: ColliderSet,
    bodies: RigidBodySet,
    params: IntegrationParameters,
    broad_phase: UnisizeBroadPhase,
}

impl Desk {
    fn ball(&mut self, x: Real, types: ActiveCollisionTypes) -> ColliderHandle {
        let ball = ColliderBuilder::ball(0.5).active_collision_types(types);
        self.colliders.insert(ball.translation(Vector::X * x))
    }

    /// How many events an update has, and how many pairs are held after it.
    fn update(&mut self, modified: &[ColliderHandle]) -> (usize, usize) {
        let Self {
            colliders,
            bodies,
            params,
            broad_phase,
        } = self;
        let mut events = Vec::new();
        broad_phase.update(params, colliders, bodies, modified, &[], &mut events);
        broad_phase.validate();
        (events.len(), broad_phase.pairs().count())
    }
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
    let [usual, all, none] = [
        ActiveCollisionTypes::default(),
        ActiveCollisionTypes::all(),
        ActiveCollisionTypes::empty(),
    ];
    let mut desk = Desk::default();
    // Without bodies they count as fixed.
    let [a, b] = [desk.ball(0.0, usual), desk.ball(0.0, usual)];
    assert_eq!(desk.update(&[a, b]), (0, 0));
    desk.colliders[b].set_active_collision_types(all);
    assert_eq!(desk.update(&[]), (0, 0));
    assert_eq!(desk.update(&[b]), (1, 1));
    desk.colliders[b].set_active_collision_types(none);
    assert_eq!(desk.update(&[a]), (0, 1));
    assert_eq!(desk.update(&[a, b]), (1, 0));
    desk.colliders[a].set_active_collision_types(all);
    desk.colliders[a].set_translation(Vector::X * 9.0);
    assert_eq!(desk.update(&[a, b]), (0, 0));
    desk.colliders[a].set_translation(Vector::ZERO);
    assert_eq!(desk.update(&[a, b]), (1, 1));
}

#[test]
fn boxes_that_rapier_would_panic_at_have_no_loosening() {
    let mut desk = Desk::default();
    let mut random = Rand32::new(1);
    let skins = [-1.0, Real::NAN, Real::INFINITY, 0.0]
        .repeat(10)
        .into_iter();
    let colliders = skins.map(|skin| collider(&mut random).contact_skin(skin));
    let handles: Vec<_> = colliders.map(|it| desk.colliders.insert(it)).collect();
    desk.update(&handles);
    assert_eq!(desk.broad_phase.stats().proxies, handles.len());
}

#[cfg(feature = "serde-serialize")]
mod snapshots {
    use super::told::told;
    use super::*;
    use serde_json::{Value, json};

    /// Two balls that touch, of which one has been moved on, and one that the broad phase does not know yet.
    fn with_boxes_handed_over() -> Desk {
        let mut desk = Desk::default();
        let handles = [0.0, 0.9, 9.0].map(|x| desk.ball(x, ActiveCollisionTypes::all()));
        desk.update(&handles[..2]);
        desk.colliders[handles[1]].set_translation(Vector::X * 8.5);
        let boxes = [handles[1], handles[2]].map(|handle| {
            let collider = &desk.colliders[handle];
            let aabb = collider.compute_broad_phase_aabb(&desk.params, &desk.bodies);
            (handle, aabb)
        });
        desk.broad_phase.set_aabbs(&desk.params, &boxes);
        desk
    }

    #[test]
    fn boxes_handed_over_are_part_of_a_snapshot() {
        let mut desk = with_boxes_handed_over();
        let ours = desk.broad_phase.clone();
        let bytes = postcard::to_stdvec(&ours).unwrap();
        let restored: UnisizeBroadPhase = postcard::from_bytes(&bytes).unwrap();
        assert_eq!(told(&restored.stats()), told(&ours.stats()));
        for broad_phase in [ours.clone(), ours, restored] {
            broad_phase.validate();
            assert_eq!(broad_phase.stats().pairs, 1);
            desk.broad_phase = broad_phase;
            assert_eq!(desk.update(&[]), (2, 1));
            let stats = desk.broad_phase.stats();
            assert_eq!([stats.listed, stats.moved, stats.proxies], [2, 2, 3]);
            assert_eq!([stats.added, stats.deleted], [1, 1]);
        }
    }

    #[test]
    fn what_is_in_a_snapshot_must_make_sense() {
        fn complaint(ours: &UnisizeBroadPhase, change: impl Fn(&mut Value)) -> String {
            let mut damaged = serde_json::to_value(ours).unwrap();
            let before = damaged.clone();
            change(&mut damaged["table"]);
            assert_ne!(damaged, before, "nothing was changed");
            let outcome = serde_json::from_value::<UnisizeBroadPhase>(damaged);
            outcome.expect_err("it is accepted").to_string()
        }
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
                table["tracker"]["touched"][0][1]["mins"][0] = json!(99.0);
            }),
            ("filter key", |table| {
                let key = table["tracker"]["proxies"][0]["key"].clone();
                table["tracker"]["other_keys"] = json!([[0, key]]);
            }),
        ];
        let desk = with_boxes_handed_over();
        for (part, change) in damages {
            let said = complaint(&desk.broad_phase, change);
            assert!(said.contains(part), "{said}");
        }
        // Two that may not meet are no candidate.
        let mut desk = Desk::default();
        let handles = [0.0, 0.5, 9.0].map(|x| desk.ball(x, ActiveCollisionTypes::default()));
        assert_eq!(desk.update(&handles), (0, 0));
        assert_eq!(desk.broad_phase.stats().candidates, 0);
        let near = json!([[0, 1]]);
        let said = complaint(&desk.broad_phase, |table| {
            table["tracker"]["near"] = near.clone();
        });
        assert!(said.contains("near"), "{said}");
    }
}
