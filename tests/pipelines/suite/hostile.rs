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

impl Desk {
    /// Two balls in reach of each other. Nothing is left out, for no collider here is on a body.
    fn new() -> (Self, [ColliderHandle; 2]) {
        let settings = Settings::default().with_filter(PairFilter::Off);
        let mut desk = Self {
            colliders: ColliderSet::new(),
            bodies: RigidBodySet::new(),
            params: IntegrationParameters::default(),
            broad_phase: UnisizeBroadPhase::with_settings(settings),
        };
        let balls = [0.0, 0.9].map(|x| desk.ball(0.5, x));
        (desk, balls)
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
fn boxes_that_are_none_are_refused_until_they_are_sound() {
    let spoil: [fn(&mut Collider, bool); 2] = [
        |ball, is_sound| ball.set_translation(along(if is_sound { 0.9 } else { Real::NAN })),
        // Inverted.
        |ball, is_sound| ball.set_shape(SharedShape::ball(if is_sound { 0.5 } else { -0.5 })),
    ];
    for make in spoil {
        let (mut desk, [a, b]) = Desk::new();
        make(&mut desk.colliders[b], false);
        assert_eq!(desk.update(&[a, b], &[]), []);
        assert_eq!(desk.counts(), [1, 1, 0]);
        make(&mut desk.colliders[b], true);
        assert_eq!(desk.update(&[b], &[]), [(true, [a, b])]);
        make(&mut desk.colliders[b], false);
        assert_eq!(desk.update(&[b], &[]), [(false, [a, b])]);
        assert_eq!(desk.counts(), [1, 1, 0]);
        assert_eq!(desk.update(&[], &[b]), []);
        assert_eq!(desk.counts(), [1, 0, 0]);
    }
}

#[test]
fn infinite_boxes_are_boxes() {
    let (mut desk, [small, all]) = Desk::new();
    desk.colliders[all].set_shape(SharedShape::ball(Real::INFINITY));
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
    let (mut desk, balls) = Desk::new();
    // So that indices are given out in order.
    for ball in balls.into_iter().rev() {
        desk.remove(ball);
    }
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

/// `tests/sequences` has random ones of all kinds.
#[test]
fn lists_that_make_no_sense() {
    let (mut desk, [a, b]) = Desk::new();
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
    assert_eq!(desk.update(&[a, b, a, b, b], &bogus), [(true, [a, b])]);
    // One that is listed as removed and as modified is removed first: its pairs end without events, and are added again.
    assert_eq!(desk.update(&[b], &[b, b]), [(true, [a, b])]);
    // It is disabled, so it stays away.
    desk.colliders[b].set_enabled(false);
    assert_eq!(desk.update(&[b], &[b]), []);
    assert_eq!(desk.counts(), [1, 0, 0]);
}

#[test]
fn an_index_of_a_newer_generation_is_another_collider() {
    let (mut desk, [a, old]) = Desk::new();
    desk.update(&[a, old], &[]);
    desk.remove(old);
    let new = desk.ball(0.5, -0.9);
    assert_eq!(old.into_raw_parts().0, new.into_raw_parts().0);
    // Even if the removal of the old one is not reported, or too late.
    assert_eq!(desk.update(&[new], &[]), [(true, [a, new])]);
    assert_eq!(desk.update(&[old], &[old]), []);
    assert_eq!(desk.counts(), [2, 0, 1]);
    // One that another set uses again is the same collider, and has moved.
    desk.colliders = ColliderSet::new();
    desk.ball(0.5, 0.0);
    let gone = desk.ball(0.5, 0.0);
    desk.remove(gone);
    assert_eq!(desk.ball(0.5, 5.0), new);
    assert_eq!(desk.update(&[a, new], &[]), [(false, [a, new])]);
}

#[test]
fn lengths_that_are_none_make_no_margin() {
    let units = [Real::NAN, -1.0, 0.0].map(|unit| (unit, 1));
    // Boxes so large that all overlap.
    let large = [Real::INFINITY, Real::MAX].map(|unit| (unit, 0));
    for (unit, ended) in units.into_iter().chain(large) {
        let (mut desk, [a, b]) = Desk::new();
        desk.params.length_unit = unit;
        assert_eq!(desk.update(&[a, b], &[]), [(true, [a, b])], "{unit}");
        desk.place(b, 20.0);
        assert_eq!(desk.update(&[b], &[]).len(), ended, "{unit}");
    }
}

#[test]
fn an_infinite_margin_makes_infinite_boxes() {
    let (mut desk, [a, b]) = Desk::new();
    let settings = desk.broad_phase.settings().with_margin(Real::INFINITY);
    desk.broad_phase = UnisizeBroadPhase::with_settings(settings);
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
fn none_or_a_hundred_thousand_colliders_on_one_body() {
    colliders_on_one_body(0);
    colliders_on_one_body(100_000);
}
