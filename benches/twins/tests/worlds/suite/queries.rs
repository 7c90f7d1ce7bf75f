//! Scene queries: the same answers as from Rapier's own tree, to the last bit.
//!
//! Random worlds, in which nothing collides so that both go on alike, and random questions with every filter. Many lengths and places come
//! from short tables, so that several colliders are often exactly as near as each other. With another margin than Rapier's, boxes are
//! others, but they only rule out what need not be tested: all answers are the same, except to the query about boxes itself, and where Parry
//! finds a hit outside the box of what is hit.
//!
//! Casts that turn are not among the questions: Parry runs them against a ball around each node of the tree, so that
//! the answer depends on the tree.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Debug;

use super::random::Random;
use super::rapier::parry::query::ShapeCastOptions;
use super::rapier::prelude::*;
use super::scenes::groups;
use super::twins::{Twins, at, cube, fixed, triple};
use super::version::{cast_shape, distance, project_feature, project_point};
use super::{Settings, cases};

/// Worlds, unless `PROPTEST_CASES` says otherwise.
const WORLDS: u32 = 64;

/// How far a ray or a shape may go.
const REACHES: [Real; 4] = [f32::MAX as Real, 50.0, 3.0, 0.25];

/// Margins in the settings, Rapier's own in half of all worlds.
const MARGINS: [Option<Real>; 8] = {
    let [none, wide, wider, negative] = [Some(0.0), Some(0.1), Some(2.0), Some(-1.0)];
    [None, none, None, wide, None, wider, None, negative]
};

/// Of what is nearest: the collider, how far it is, and the rest, printed so that numbers read back the same.
type Nearest = Option<(ColliderHandle, Real, String)>;

/// Two worlds, and the colliders in them, in the order in which they were inserted.
struct Asked {
    twins: Twins,
    random: Random,
    handles: Vec<ColliderHandle>,
    has_default_margin: bool,
    hits: usize,
}

impl Asked {
    fn new(seed: u64) -> Self {
        let mut random = Random::new(seed);
        let margin = random.pick(&MARGINS);
        let settings = Settings::default();
        let settings = margin.map_or(settings, |margin| settings.with_margin(margin));
        let mut asked = Self {
            twins: Twins::with(settings).without_gravity(),
            random,
            handles: Vec::new(),
            has_default_margin: margin.is_none(),
            hits: 0,
        };
        // These are never removed. Rapier's tree loops forever, or panics, once it has lost all but one of its colliders.
        for x in [-20.0, 0.0, 20.0] {
            let none = ActiveCollisionTypes::empty();
            let ball = ColliderBuilder::ball(0.5).active_collision_types(none);
            asked.twins.insert(fixed(x, 15.0), ball);
        }
        let most = asked.random.pick(&[6, 6, 6, 40, 40, 40, 250]);
        (0..asked.random.below(most)).for_each(|_| asked.insert());
        asked
    }

    fn insert(&mut self) {
        let random = &mut self.random;
        let members = Group::from_bits_truncate(random.pick(&[u32::MAX, 1, 2, 3]));
        let collider = ColliderBuilder::new(random.shape())
            .sensor(random.below(5) == 0)
            .enabled(random.below(10) > 0)
            .collision_groups(groups(members, Group::all()))
            .active_collision_types(ActiveCollisionTypes::empty());
        let (pose, velocity) = (random.pose(), random.direction());
        let body = match random.below(5) {
            0 => None,
            1 => Some(RigidBodyBuilder::fixed()),
            2 => Some(RigidBodyBuilder::kinematic_velocity_based()),
            _ => Some(RigidBodyBuilder::dynamic()),
        };
        let handle = self.twins.both(|world| match &body {
            None => world.colliders.insert(collider.clone().position(pose)),
            Some(body) => {
                let mut body = body.clone().linvel(velocity).build();
                body.set_position(pose, true);
                let body = world.insert(body, collider.clone());
                world.bodies[body].colliders()[0]
            }
        });
        self.handles.push(handle);
    }

    fn change(&mut self) {
        let (kind, is_on) = (self.random.below(14), self.random.below(2) == 0);
        if kind < 4 || self.handles.is_empty() {
            return self.insert();
        }
        let nth = self.random.below(self.handles.len());
        let handle = self.handles[nth];
        let (pose, shape) = (self.random.pose(), self.random.shape());
        self.twins.both(|world| {
            let parent = world.colliders[handle].parent();
            match kind {
                4..8 => return world.remove_collider(handle),
                8 | 9 if parent.is_some() => {
                    world.bodies[parent.expect("it has one")].set_position(pose, true);
                    return;
                }
                _ => {}
            }
            let collider = &mut world.colliders[handle];
            match kind {
                8 | 9 => collider.set_position(pose),
                10 | 11 => collider.set_enabled(is_on),
                12 => collider.set_shape(shape.clone()),
                _ => collider.set_sensor(is_on),
            }
        });
        if kind < 8 {
            self.handles.remove(nth);
        }
    }

    /// Compares the leaves of both trees: all colliders that are enabled, with the same boxes.
    fn compare_leaves(&mut self) {
        let enabled = self.twins.ours.colliders.iter_enabled();
        let enabled: BTreeSet<_> = enabled.map(|(handle, _)| index(handle)).collect();
        let [ours, theirs] = self.twins.answers(|_, scene| leaves(&scene, enabled.len()));
        assert!(ours.keys().eq(&enabled), "{ours:?}, not {enabled:?}");
        assert!(theirs.keys().eq(&enabled), "{theirs:?}, not {enabled:?}");
        assert!(!self.has_default_margin || ours == theirs);
    }

    /// A filter, but for the predicate.
    fn filter(&mut self) -> QueryFilter<'static> {
        let random = &mut self.random;
        let nth = |random: &mut Random| match (random.below(7), self.handles.len()) {
            (0, 1..) => Some(random.pick(&self.handles)),
            _ => None,
        };
        let (collider, other) = (nth(random), nth(random));
        let flags = random.pick(&[0, 0, 0, 1]) * random.below(32) as u32;
        let bits = Group::from_bits_truncate(random.pick(&[u32::MAX, 1, 2, 3]));
        QueryFilter {
            flags: QueryFilterFlags::from_bits_truncate(flags),
            groups: (random.below(7) == 0).then(|| groups(bits, bits)),
            exclude_collider: collider,
            exclude_rigid_body: other.and_then(|other| self.twins.ours.colliders[other].parent()),
            predicate: None,
        }
    }

    fn has_any(&self, filter: QueryFilter<'_>) -> bool {
        let world = &self.twins.ours;
        let mut enabled = world.colliders.iter_enabled();
        enabled.any(|(handle, collider)| filter.test(&world.bodies, handle, collider))
    }

    /// Compares all that both find.
    fn all<T: Debug>(
        &mut self,
        filter: QueryFilter<'_>,
        ask: impl Fn(&QueryPipeline<'_>) -> Vec<(ColliderHandle, T)>,
    ) {
        let [ours, theirs] = self.twins.answers_with(filter, |_, scene| {
            let found = ask(&scene).into_iter();
            let found = found.map(|(handle, rest)| (index(handle), format!("{rest:?}")));
            let mut found: Vec<_> = found.collect();
            found.sort();
            found
        });
        assert_eq!(ours, theirs);
        self.hits += ours.len();
    }

    /// Compares what both find nearest.
    fn nearest(&mut self, filter: QueryFilter<'_>, ask: impl Fn(&QueryPipeline<'_>) -> Nearest) {
        let [ours, theirs] = self.twins.answers_with(filter, |_, scene| ask(&scene));
        self.hits += usize::from(ours.is_some());
        if ours == theirs {
            return;
        }
        // Which of several equally near colliders is found depends on the shape of the tree.
        let (Some(ours), Some(theirs)) = (&ours, &theirs) else {
            panic!("{ours:?} is not {theirs:?}");
        };
        assert!(ours.1 == theirs.1, "{ours:?} is not {theirs:?}");
        for tied in [ours, theirs] {
            let is_it = |handle, collider: &Collider| {
                handle == tied.0 && filter.predicate.is_none_or(|holds| holds(handle, collider))
            };
            let only_it = QueryFilter {
                predicate: Some(&is_it),
                ..filter
            };
            let [_, alone] = self.twins.answers_with(only_it, |_, scene| ask(&scene));
            assert_eq!(Some(tied), alone.as_ref(), "they are not equally near");
        }
    }

    /// Whether Parry finds a hit that is off by more than Rapier's margin, as on a capsule 400 long and 0.001 thick: whether it is asked
    /// about that collider depends on the margin.
    fn hits_outside_a_box(
        &mut self,
        filter: QueryFilter<'_>,
        ray: Ray,
        reach: Real,
        solid: bool,
    ) -> bool {
        let found = self.twins.answers_with(filter, |world, scene| {
            scene
                .intersect_ray(ray, reach, solid)
                .any(|(handle, _, hit)| {
                    let at = ray.point_at(hit.time_of_impact);
                    let near = Aabb::new(at, at).loosened(0.01);
                    !near.intersects(&world.colliders[handle].compute_aabb())
                })
        });
        found.contains(&true)
    }

    fn question(&mut self, filter: QueryFilter<'_>) {
        let (reach, solid) = (self.random.pick(&REACHES), self.random.below(2) == 0);
        let (place, direction) = (self.random.place(), self.random.direction());
        let (pose, shape) = (self.random.pose(), self.random.probe());
        match self.random.below(16) {
            0..4 => {
                let ray = Ray::new(place.into(), direction);
                if !self.has_default_margin && self.hits_outside_a_box(filter, ray, reach, solid) {
                    return;
                }
                self.all(filter, |scene| {
                    let hits = scene.intersect_ray(ray, reach, solid);
                    hits.map(|(handle, _, hit)| (handle, hit)).collect()
                });
                self.nearest(filter, |scene| {
                    let hit = scene.cast_ray(&ray, reach, solid);
                    hit.map(|(handle, time)| (handle, time, String::new()))
                });
                self.nearest(filter, |scene| {
                    let hit = scene.cast_ray_and_get_normal(&ray, reach, solid);
                    hit.map(|(handle, hit)| (handle, hit.time_of_impact, format!("{hit:?}")))
                });
            }
            4..8 => {
                // Not the centre of anything: the point nearest to the centre of a ball is NaN in Parry.
                let place = place + triple([0.013, -0.017, 0.011]);
                self.all(filter, |scene| {
                    let found = scene.intersect_point(place.into());
                    found.map(|(handle, _)| (handle, ())).collect()
                });
                if !self.has_any(filter) {
                    // Parry panics if there is nothing to project on.
                    return;
                }
                self.nearest(filter, |scene| {
                    let (handle, found) = project_point(scene, place, solid)?;
                    Some((handle, distance(found.point, place), format!("{found:?}")))
                });
                self.nearest(filter, |scene| {
                    let (handle, found, feature) = project_feature(scene, place)?;
                    let far = distance(found.point, place);
                    Some((handle, far, format!("{found:?} {feature:?}")))
                });
            }
            8..11 => self.all(filter, |scene| {
                let found = scene.intersect_shape(pose, &*shape);
                found.map(|(handle, _)| (handle, ())).collect()
            }),
            11..13 if self.has_default_margin => {
                let half = triple([(); 3].map(|()| self.random.length()));
                self.region(Aabb::from_half_extents(place.into(), half));
            }
            _ => {
                let options = ShapeCastOptions {
                    max_time_of_impact: reach,
                    target_distance: self.random.pick(&[0.0, 0.1, 1.0]),
                    stop_at_penetration: solid,
                    compute_impact_geometry_on_penetration: true,
                };
                let cast = |scene: &QueryPipeline<'_>| {
                    let hit = cast_shape(scene, &pose, direction, &*shape, options);
                    hit.map(|(handle, hit)| (handle, hit.time_of_impact, format!("{hit:?}")))
                };
                let probe = shape.compute_aabb(&pose).loosened(options.target_distance);
                let found = self.twins.answers_with(filter, |world, scene| {
                    let hit = cast(&scene)?;
                    let reached = world.colliders[hit.0].compute_aabb();
                    Some(hit.1 + 0.001 < first_touch(&probe, direction, &reached))
                });
                // Parry's casts of shapes may be off too: whether it is asked about such a collider depends on the shape of the tree.
                if !found.contains(&Some(true)) {
                    self.nearest(filter, cast);
                }
            }
        }
    }

    /// What may be in a region goes by the boxes of the leaves; of those that are children of the root, Parry does not look at them. In the
    /// own tree of Rapier 0.36, those that a step has set are larger than their ancestors until the next step, by the margin, so it may miss
    /// one of which only the margin is there.
    fn region(&mut self, region: Aabb) {
        let [(expected, ours), (_, theirs)] = self.twins.answers(|_, scene| {
            let mut leaves = leaves(&scene, usize::MAX);
            leaves.retain(|_, leaf| leaf.intersects(&region));
            let expected: BTreeSet<_> = leaves.into_keys().collect();
            let found = scene.intersect_aabb_conservative(region);
            let mut found: BTreeSet<_> = found.map(|(handle, _)| index(handle)).collect();
            found.retain(|index| expected.contains(index));
            (expected, found)
        });
        assert_eq!(ours, expected);
        assert!(ours.is_superset(&theirs), "{ours:?} and {theirs:?}");
        self.hits += ours.len();
    }
}

/// When a moving box touches another that rests; infinity if it never does.
fn first_touch(
    moving: &Aabb,
    direction: impl std::ops::Index<usize, Output = Real>,
    resting: &Aabb,
) -> Real {
    let (mut first, mut last): (Real, Real) = (0.0, Real::INFINITY);
    for axis in 0..DIM {
        let speed = direction[axis];
        let ahead = resting.mins[axis] - moving.maxs[axis];
        let behind = resting.maxs[axis] - moving.mins[axis];
        if speed == 0.0 {
            if ahead > 0.0 || behind < 0.0 {
                return Real::INFINITY;
            }
            continue;
        }
        let times = [ahead / speed, behind / speed];
        first = first.max(times[0].min(times[1]));
        last = last.min(times[0].max(times[1]));
    }
    if first <= last { first } else { Real::INFINITY }
}

fn index(handle: ColliderHandle) -> u32 {
    handle.into_raw_parts().0
}

/// The boxes of the leaves by index, at most one more than this many of them, as a tree that has a cycle has no end.
fn leaves(scene: &QueryPipeline<'_>, most: usize) -> BTreeMap<u32, Aabb> {
    let leaves = scene.bvh.leaves(|_| true).take(most.saturating_add(1));
    let boxed = |index| Some((index, scene.bvh.leaf_node(index)?.aabb()));
    leaves.filter_map(boxed).collect()
}

/// Asks questions in this many rounds, between which the world changes. Returns how many colliders were found.
fn ask(seed: u64, rounds: usize) -> usize {
    println!("the world of seed {seed}");
    let mut asked = Asked::new(seed);
    for _ in 0..rounds {
        // At times nobody asks, for long enough for the tree to be given up.
        let steps = if asked.random.below(30) == 0 { 100 } else { 4 };
        asked.twins.steps(1 + asked.random.below(steps));
        asked.compare_leaves();
        for _ in 0..asked.random.below(24) {
            let multiples = asked.random.pick(&[1, 2, 3]);
            let is_multiple = |handle, _: &Collider| index(handle) % multiples == 0;
            let mut filter = asked.filter();
            if asked.random.below(7) == 0 {
                filter.predicate = Some(&is_multiple);
            }
            asked.question(filter);
        }
        (0..asked.random.below(12)).for_each(|_| asked.change());
    }
    asked.hits
}

#[test]
fn random_questions_in_random_worlds() {
    let worlds = cases(WORLDS).into();
    let hits: usize = (0..worlds).map(|seed| ask(seed, 6)).sum();
    assert!(hits as u64 > 20 * worlds, "only {hits} hits");
}

/// The tree that is kept is brought up to date hundreds of times, given new leaves, and loses some.
#[test]
fn random_questions_in_a_world_that_goes_on() {
    let hits = ask(1 << 32, 400);
    assert!(hits > 400, "only {hits} hits");
}

/// Parry builds trees of one and of two leaves as special cases.
#[test]
fn a_few_colliders_with_any_index_or_none() {
    for left in 0..=4 {
        let mut twins = Twins::weightless();
        let count = if left > 0 { 5 } else { 0 };
        let all: Vec<_> = (0..count)
            .map(|i| twins.insert(fixed(3.0 * i as Real, 0.0), cube()))
            .collect();
        twins.step();
        for &(body, _) in &all[..count - left] {
            twins.remove(body);
        }
        twins.step();
        let mut hits = 0;
        for i in 0..5 {
            let ray = Ray::new(at(3.0 * i as Real, -5.0).into(), at(0.0, 1.0));
            let hit = twins.same(|scene| scene.cast_ray(&ray, 100.0, true));
            hits += usize::from(hit.is_some());
        }
        assert_eq!(hits, left);
    }
}
