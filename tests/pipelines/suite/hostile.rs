//! Input that no sound program makes, given to the broad phase directly, and what must happen for each kind.

use super::rapier::prelude::*;
use super::twins::at;
use super::version::{Vector, remove_collider};
use super::{PairFilter, Settings, Steppable, UnisizeBroadPhase, World, install};

/// Whether a pair is added, and its colliders.
type Event = (bool, [ColliderHandle; 2]);

/// Colliders, and a broad phase that gets hand-made lists of them.
struct Desk {
    colliders: ColliderSet,
    bodies: RigidBodySet,
    params: IntegrationParameters,
    broad_phase: UnisizeBroadPhase,
}

impl Default for Desk {
    fn default() -> Self {
        Self::with(Settings::default())
    }
}

impl Desk {
    /// Nothing is left out, for no collider here is on a body.
    fn with(settings: Settings) -> Self {
        let settings = settings.with_filter(PairFilter::Off);
        Self {
            colliders: ColliderSet::new(),
            bodies: RigidBodySet::new(),
            params: IntegrationParameters::default(),
            broad_phase: UnisizeBroadPhase::with_settings(settings),
        }
    }

    /// A ball whose centre is this far along the first axis.
    fn ball(&mut self, radius: Real, x: Real) -> ColliderHandle {
        self.colliders
            .insert(ColliderBuilder::ball(radius).translation(along(x)))
    }

    fn place(&mut self, handle: ColliderHandle, x: Real) {
        self.colliders[handle].set_translation(along(x));
    }

    fn remove(&mut self, handle: ColliderHandle) {
        let mut world = World::new(Vector::default());
        std::mem::swap(&mut world.colliders, &mut self.colliders);
        remove_collider(&mut world, handle);
        self.colliders = world.colliders;
    }

    fn update(&mut self, modified: &[ColliderHandle], removed: &[ColliderHandle]) -> Vec<Event> {
        let mut events = Vec::new();
        self.broad_phase.update(
            &self.params,
            &self.colliders,
            &self.bodies,
            modified,
            removed,
            &mut events,
        );
        self.broad_phase.validate();
        let events = events.iter().map(|event| match event {
            BroadPhasePairEvent::AddPair(pair) => (true, [pair.collider1, pair.collider2]),
            BroadPhasePairEvent::DeletePair(pair) => (false, [pair.collider1, pair.collider2]),
        });
        events.collect()
    }

    /// How many colliders have a proxy, how many are refused, and how many pairs are held.
    fn counts(&self) -> [usize; 3] {
        let stats = self.broad_phase.stats();
        [stats.proxies, stats.refused, stats.pairs]
    }
}

fn along(x: Real) -> Vector {
    at(x, 0.0)
}

#[test]
fn boxes_with_nan_are_refused_until_they_are_sound() {
    let mut desk = Desk::default();
    let [a, b] = [desk.ball(0.5, 0.0), desk.ball(0.5, 0.9)];
    desk.place(b, Real::NAN);
    assert_eq!(desk.update(&[a, b], &[]), []);
    assert_eq!(desk.counts(), [1, 1, 0]);
    desk.place(b, 0.9);
    assert_eq!(desk.update(&[b], &[]), [(true, [a, b])]);
    desk.place(b, Real::NAN);
    assert_eq!(desk.update(&[b], &[]), [(false, [a, b])]);
    assert_eq!(desk.counts(), [1, 1, 0]);
    assert_eq!(desk.update(&[], &[b]), []);
    assert_eq!(desk.counts(), [1, 0, 0]);
}

#[test]
fn inverted_boxes_are_refused_until_they_are_sound() {
    let mut desk = Desk::default();
    let [a, b] = [desk.ball(0.5, 0.0), desk.ball(-0.5, 0.9)];
    assert_eq!(desk.update(&[a, b], &[]), []);
    assert_eq!(desk.counts(), [1, 1, 0]);
    desk.colliders[b].set_shape(SharedShape::ball(0.5));
    assert_eq!(desk.update(&[b], &[]), [(true, [a, b])]);
    desk.colliders[b].set_shape(SharedShape::ball(-0.5));
    assert_eq!(desk.update(&[b], &[]), [(false, [a, b])]);
    assert_eq!(desk.counts(), [1, 1, 0]);
}

#[test]
fn infinite_boxes_are_boxes() {
    let mut desk = Desk::default();
    let [small, all] = [desk.ball(0.5, 0.0), desk.ball(Real::INFINITY, 3.0)];
    let [far, beside] = [Real::INFINITY; 2].map(|x| desk.ball(0.5, x));
    let mut events = desk.update(&[small, all, far, beside], &[]);
    events.sort_by_key(|event| event.1.map(|handle| handle.into_raw_parts()));
    let pairs = [[small, all], [all, far], [all, beside], [far, beside]];
    assert_eq!(events, pairs.map(|pair| (true, pair)));
    desk.place(far, Real::NEG_INFINITY);
    assert_eq!(desk.update(&[far], &[]), [(false, [far, beside])]);
    // Infinity minus infinity is NaN.
    desk.place(all, Real::INFINITY);
    assert_eq!(desk.update(&[all], &[]).len(), 3);
    assert_eq!(desk.counts(), [3, 1, 0]);
}

#[test]
fn denormals_and_negative_zeros_are_numbers() {
    let mut desk = Desk::default();
    // No prediction and no margin, so that boxes are those of the shapes.
    desk.params.length_unit = 0.0;
    let least = Real::from_bits(1);
    let points = [-0.0, 0.0, least, -least, 2.0 * least].map(|x| desk.ball(0.0, x));
    let zeros = [points[0], points[1]];
    assert_eq!(desk.update(&points, &[]), [(true, zeros)]);
    let ball = desk.ball(least, 0.0);
    let mut met = desk.update(&[ball], &[]);
    met.sort_by_key(|event| event.1.map(|handle| handle.into_raw_parts()));
    let expected = [0, 1, 2, 3].map(|i| (true, [points[i], ball]));
    assert_eq!(met, expected);
    // From one zero to the other is no move.
    desk.place(points[0], 0.0);
    assert_eq!(desk.update(&[points[0]], &[]), []);
    assert_eq!(desk.broad_phase.stats().moved, 0);
}

#[test]
fn one_listed_twice_is_read_once_as_it_were() {
    let mut desk = Desk::default();
    let [a, b] = [desk.ball(0.5, 0.0), desk.ball(0.5, 0.9)];
    assert_eq!(desk.update(&[a, b, a, b, b], &[]), [(true, [a, b])]);
    desk.place(b, 5.0);
    assert_eq!(desk.update(&[b, a, b], &[]), [(false, [a, b])]);
    desk.place(b, 0.9);
    assert_eq!(desk.update(&[b, b], &[]), [(true, [a, b])]);
    desk.remove(b);
    assert_eq!(desk.update(&[], &[b, b]), []);
    assert_eq!(desk.counts(), [1, 0, 0]);
}

#[test]
fn one_listed_as_removed_and_as_modified_is_removed_first() {
    let mut desk = Desk::default();
    let [a, b] = [desk.ball(0.5, 0.0), desk.ball(0.5, 0.9)];
    desk.update(&[a, b], &[]);
    // It still exists, so it counts as new: its pairs end without events and are added again.
    assert_eq!(desk.update(&[b], &[b]), [(true, [a, b])]);
    // It is disabled or gone, so it stays away.
    desk.colliders[b].set_enabled(false);
    assert_eq!(desk.update(&[b], &[b]), []);
    assert_eq!(desk.counts(), [1, 0, 0]);
    desk.remove(a);
    assert_eq!(desk.update(&[a], &[a]), []);
    assert_eq!(desk.counts(), [0, 0, 0]);
}

#[test]
fn handles_that_never_existed_are_passed_over() {
    let mut desk = Desk::default();
    let [a, b] = [desk.ball(0.5, 0.0), desk.ball(0.5, 0.9)];
    let (index, generation) = a.into_raw_parts();
    let bogus = [
        (index, generation + 1),
        (index, u32::MAX),
        (2, 0),
        (1 << 31, 0),
        (u32::MAX - 1, 0),
        (u32::MAX, 0),
        (u32::MAX, u32::MAX),
    ]
    .map(|(index, generation)| ColliderHandle::from_raw_parts(index, generation));
    assert_eq!(desk.update(&bogus, &bogus), []);
    assert_eq!(desk.counts(), [0, 0, 0]);
    assert_eq!(desk.update(&[a, b], &bogus), [(true, [a, b])]);
    assert_eq!(desk.update(&bogus, &bogus), []);
    assert_eq!(desk.counts(), [2, 0, 1]);
}

#[test]
fn an_index_of_a_newer_generation_is_another_collider() {
    let mut desk = Desk::default();
    let [a, old] = [desk.ball(0.5, 0.0), desk.ball(0.5, 0.9)];
    desk.update(&[a, old], &[]);
    desk.remove(old);
    let new = desk.ball(0.5, -0.9);
    assert_eq!(old.into_raw_parts().0, new.into_raw_parts().0);
    // Even if the removal of the old one is not reported, or too late.
    assert_eq!(desk.update(&[new], &[]), [(true, [a, new])]);
    assert_eq!(desk.update(&[old], &[old]), []);
    assert_eq!(desk.counts(), [2, 0, 1]);
}

#[test]
fn a_handle_that_another_set_uses_again_is_the_same_collider() {
    let mut desk = Desk::default();
    let [a, b] = [desk.ball(0.5, 0.0), desk.ball(0.5, 0.9)];
    desk.update(&[a, b], &[]);
    desk.colliders = ColliderSet::new();
    assert_eq!([desk.ball(0.5, 0.0), desk.ball(0.5, 5.0)], [a, b]);
    assert_eq!(desk.update(&[a, b], &[]), [(false, [a, b])]);
}

#[test]
fn an_empty_world_has_no_pairs() {
    let mut desk = Desk::default();
    assert_eq!(desk.update(&[], &[]), []);
    let bogus = [
        ColliderHandle::invalid(),
        ColliderHandle::from_raw_parts(0, 0),
    ];
    assert_eq!(desk.update(&bogus, &[]), []);
    assert_eq!(desk.update(&[], &bogus), []);
    assert_eq!(desk.counts(), [0, 0, 0]);
    assert_eq!(desk.broad_phase.pairs().count(), 0);
    assert_eq!(desk.broad_phase.stats().updates, 2);
}

#[test]
fn lengths_that_are_none_make_no_margin() {
    let units = [Real::NAN, -1.0, 0.0].map(|unit| (unit, 1));
    // Boxes so large that all overlap.
    let large = [Real::INFINITY, Real::MAX].map(|unit| (unit, 0));
    for (unit, ended) in units.into_iter().chain(large) {
        let mut desk = Desk::default();
        desk.params.length_unit = unit;
        let [a, b] = [desk.ball(0.5, 0.0), desk.ball(0.5, 0.9)];
        assert_eq!(desk.update(&[a, b], &[]), [(true, [a, b])], "{unit}");
        desk.place(b, 20.0);
        assert_eq!(desk.update(&[b], &[]).len(), ended, "{unit}");
    }
}

#[test]
fn an_infinite_margin_makes_infinite_boxes() {
    let mut desk = Desk::with(Settings::default().with_margin(Real::INFINITY));
    let [a, b] = [desk.ball(0.5, 0.0), desk.ball(0.5, 0.9)];
    assert_eq!(desk.update(&[a, b], &[]), [(true, [a, b])]);
    // An infinite side minus an infinite margin would be NaN, so it gets no margin.
    desk.place(a, Real::INFINITY);
    assert_eq!(desk.update(&[a], &[]), [(false, [a, b])]);
    desk.place(b, 1.9);
    assert_eq!(desk.update(&[b], &[]), [(true, [a, b])]);
    assert_eq!(desk.counts(), [2, 0, 1]);
}

/// Steps a world with this many colliders on one body, which is moved about, and one without a body.
fn colliders_on_one_body(count: usize) {
    let mut world = World::new(Vector::default());
    let mut broad_phase = install(UnisizeBroadPhase::new());
    let kinematic = RigidBodyBuilder::kinematic_position_based();
    let body = world.bodies.insert(kinematic);
    for i in 0..count {
        let collider = ColliderBuilder::ball(0.5).translation(along(2.0 * i as Real));
        world
            .colliders
            .insert_with_parent(collider, body, &mut world.bodies);
    }
    let other = ColliderBuilder::ball(0.5).active_collision_types(ActiveCollisionTypes::all());
    let other = world.colliders.insert(other.translation(along(-10.0)));
    let last = 2.0 * (count as Real - 1.0);
    for (x, pairs) in [(0.0, 0), (-10.0, 1), (-10.0 - last, 1), (5.0, 0)] {
        world.bodies[body].set_translation(along(x), true);
        world.step(broad_phase.for_step(), &(), &());
        broad_phase.validate();
        let pairs = pairs.min(count);
        let stats = broad_phase.stats();
        assert_eq!([stats.proxies, stats.pairs], [count + 1, pairs]);
        let touching = world.narrow_phase.contact_pairs_with(other);
        assert_eq!(touching.count(), pairs);
    }
    world.remove(body);
    world.step(broad_phase.for_step(), &(), &());
    broad_phase.validate();
    let stats = broad_phase.stats();
    assert_eq!([stats.proxies, stats.pairs], [1, 0]);
}

#[test]
fn no_colliders_on_a_body() {
    colliders_on_one_body(0);
}

#[test]
fn a_hundred_thousand_colliders_on_one_body() {
    colliders_on_one_body(100_000);
}
