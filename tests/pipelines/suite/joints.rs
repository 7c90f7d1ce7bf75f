//! Joined bodies.

use super::hinge;
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};

#[test]
fn joined_bodies_without_contacts() {
    let mut twins = Twins::weightless();
    let (left_body, left) = twins.insert(dynamic(0.0, 0.0), cube());
    let (right_body, right) = twins.insert(dynamic(0.9, 0.0), cube());
    let joint = FixedJointBuilder::new()
        .contacts_enabled(false)
        .local_anchor1(at(0.9, 0.0).into());
    let joint = twins.both(|world| {
        let joints = &mut world.impulse_joints;
        joints.insert(left_body, right_body, joint, true)
    });
    assert!(!twins.steps(5).touches(left, right));
    twins.both(|world| world.impulse_joints.remove(joint, true).is_some());
    assert!(twins.step().touches(left, right));
}

/// A rope that swings against a wall.
#[test]
fn a_rope() {
    let mut twins = Twins::heavy();
    let (_, wall) = twins.insert(fixed(-1.0, -6.0), cuboid([0.5, 2.0, 3.0]));
    let (mut parent, _) = twins.insert(fixed(0.0, 0.0), ColliderBuilder::ball(0.1));
    let mut links = Vec::new();
    for i in 1..=8 {
        let (link, ball) = twins.insert(dynamic(i as Real, 0.0), ColliderBuilder::ball(0.3));
        let joint = hinge().local_anchor2(at(-1.0, 0.0).into());
        twins.both(|world| world.impulse_joints.insert(parent, link, joint, true));
        links.push(ball);
        parent = link;
    }
    twins.step_until(|seen| links.iter().any(|&link| seen.touches(link, wall)));
    twins.steps(20);
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
        let joint = hinge()
            .local_anchor2(at(-1.0, 0.0).into())
            .contacts_enabled(false);
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
