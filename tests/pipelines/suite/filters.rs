//! Filters that keep touching colliders from colliding, and events of those that do collide.

use super::hinge;
use super::rapier::prelude::*;
use super::snapshot::Event;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};

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

#[test]
fn joined_bodies_without_contacts() {
    let mut twins = Twins::weightless();
    let (left_body, left) = twins.insert(dynamic(0.0, 0.0), cube());
    let (right_body, right) = twins.insert(dynamic(0.9, 0.0), cube());
    let joint = FixedJointBuilder::new().contacts_enabled(false);
    let joint = joint.local_anchor1(at(0.9, 0.0).into());
    let joint = twins.both(|world| {
        let joints = &mut world.impulse_joints;
        joints.insert(left_body, right_body, joint, true)
    });
    assert!(!twins.steps(5).touches(left, right));
    twins.both(|world| world.impulse_joints.remove(joint, true).is_some());
    assert!(twins.step().touches(left, right));
}

#[test]
fn multibody() {
    let mut twins = Twins::heavy();
    let (root, _) = twins.insert(fixed(0.0, 0.0), ColliderBuilder::ball(0.6));
    let (_, wall) = twins.insert(fixed(-1.6, -3.0), cuboid([0.5, 2.0, 3.0]));
    let mut parent = root;
    let mut links = Vec::new();
    for i in 1..=3 {
        let (link, ball) = twins.insert(dynamic(i as Real, 0.0), ColliderBuilder::ball(0.4));
        let joint = hinge().local_anchor2(at(-1.0, 0.0).into());
        let joint = joint.contacts_enabled(false);
        twins.both(|world| {
            let joints = &mut world.multibody_joints;
            joints.insert(parent, link, joint, true).is_some()
        });
        links.push(ball);
        parent = link;
    }
    let hit = twins.step_until(|seen| links.iter().any(|&link| seen.touches(link, wall)));
    assert!(!hit.touches(links[0], links[1]));
    twins.steps(10);
}
