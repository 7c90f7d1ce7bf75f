//! Filters that keep touching colliders from colliding, and events of those that do collide.

use super::rapier::prelude::*;
use super::snapshot::Event;
use super::twins::{Twins, at, cube, dynamic, fixed};
use super::{PairFilter, World};

/// Lets nothing with odd user data touch anything.
struct OddIsThin;

impl OddIsThin {
    fn passes(context: &PairFilterContext<'_>) -> bool {
        let colliders = [context.collider1, context.collider2];
        colliders
            .iter()
            .all(|&handle| context.colliders[handle].user_data % 2 == 0)
    }
}

impl PhysicsHooks for OddIsThin {
    fn filter_contact_pair(&self, context: &PairFilterContext<'_>) -> Option<SolverFlags> {
        Self::passes(context).then(SolverFlags::default)
    }

    fn filter_intersection_pair(&self, context: &PairFilterContext<'_>) -> bool {
        Self::passes(context)
    }
}

#[test]
fn physics_hooks() {
    let mut twins = Twins::heavy();
    twins.hooks = Box::new(OddIsThin);
    let (_, floor) = twins.insert_floor();
    let hooks = ActiveHooks::all();
    let mut cubes = Vec::new();
    for i in 0..6 {
        let cube = cube().user_data(i).active_hooks(hooks).sensor(i >= 4);
        cubes.push(twins.insert(dynamic(3.0 * i as Real, 0.7), cube).1);
    }
    let seen = twins.steps(20);
    for (i, &cube) in cubes.iter().enumerate() {
        assert_eq!(seen.touches(cube, floor), i < 4 && i % 2 == 0);
        assert_eq!(seen.intersects(cube, floor), i == 4);
    }
    twins.change(cubes[1], |cube| cube.user_data = 0);
    twins.change(cubes[0], |cube| cube.user_data = 1);
    let seen = twins.steps(2);
    assert!(seen.touches(cubes[1], floor) && !seen.touches(cubes[0], floor));
}

#[test]
fn contact_force_events() {
    let mut twins = Twins::heavy();
    let (_, floor) = twins.insert_floor();
    twins.insert(
        dynamic(0.0, 3.0),
        cube().contact_force_event_threshold(100.0),
    );
    twins.change(floor, |floor| {
        floor.set_contact_force_event_threshold(Real::MAX)
    });
    let is_force = |event: &Event| matches!(event, Event::Force(..));
    twins.step_until(|seen| seen.events.iter().any(is_force));
    twins.steps(60);
}

/// Who asks a hook wants to be asked about all pairs of boxes, also if what asks rests and was told to by nothing but that.
#[test]
fn hooks_that_are_set_on_what_rests() {
    let mut twins = Twins::with_filter(PairFilter::Shapes).without_gravity();
    let ball = || ColliderBuilder::ball(0.5);
    let (_, still) = twins.insert(fixed(0.0, 0.0), ball());
    let (_, other) = twins.insert(dynamic(0.8, 0.8).can_sleep(false), ball());
    let is_pair = |world: &World| world.narrow_phase.contact_pair(still, other).is_some();
    twins.steps(3);
    assert!(!is_pair(&twins.ours) && is_pair(&twins.theirs));
    twins.change(still, |still| {
        still.set_active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS)
    });
    twins.steps(2);
    assert!(is_pair(&twins.ours) && is_pair(&twins.theirs));
}

/// Of a body that has more than 32 colliders, most lie within it, so they keep their boxes.
#[test]
fn parts_of_large_bodies_keep_their_boxes() {
    for (parts, is_held) in [(32, false), (33, true)] {
        let mut twins = Twins::with_filter(PairFilter::Shapes).without_gravity();
        let (body, first) = twins.insert(dynamic(0.0, 0.0), ColliderBuilder::ball(0.5));
        for i in 1..parts {
            let place = at(-1.5 * i as Real, 0.0);
            twins.insert_part(body, ColliderBuilder::ball(0.5).translation(place));
        }
        // In the corner of the box around the first ball, and away from it.
        let (_, other) = twins.insert(dynamic(0.8, 0.8), ColliderBuilder::ball(0.5));
        for _ in 0..3 {
            twins.step();
            let is_found = twins
                .unisize
                .pairs()
                .any(|pair| [pair.collider1, pair.collider2] == [first, other]);
            assert_eq!(is_found, is_held, "{parts} parts");
            // Rapier 0.36 hands it over.
            twins.change_body(body, |body| body.set_linvel(at(0.0, 0.001), true));
        }
    }
}
