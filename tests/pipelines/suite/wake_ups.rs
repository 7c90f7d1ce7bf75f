//! Changes of fixed bodies that sleeping neighbours must notice.

use super::World;
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};

const APART: InteractionGroups = InteractionGroups::new(Group::GROUP_2, Group::GROUP_2);
const OTHERS: InteractionGroups = InteractionGroups::new(Group::GROUP_1, Group::GROUP_1);

/// A cube asleep on the floor, and a fixed post through it that does not touch it as yet.
fn post_in_a_sleeper() -> (Twins, RigidBodyHandle, ColliderHandle, ColliderHandle) {
    let mut twins = Twins::heavy();
    twins.insert_floor();
    let (sleeper, cube) = twins.insert(dynamic(0.0, 0.5), cube().collision_groups(OTHERS));
    let post = cuboid([0.1, 2.0, 0.1]).collision_groups(APART);
    let (_, post) = twins.insert(fixed(0.5, 0.0), post);
    let seen = twins.step_until(|seen| seen.sleeps(sleeper));
    assert!(!seen.touches(cube, post));
    (twins, sleeper, cube, post)
}

#[test]
fn a_post_that_gets_another_group() {
    let (mut twins, sleeper, cube, post) = post_in_a_sleeper();
    twins.change(post, |post| post.set_collision_groups(OTHERS));
    let seen = twins.step();
    assert!(seen.touches(cube, post));
    assert!(!seen.sleeps(sleeper));
}

#[test]
fn a_post_that_moves_into_a_sleeper() {
    let (mut twins, _, cube, post) = post_in_a_sleeper();
    twins.change(post, |post| post.set_translation_wrt_parent(at(5.0, 0.0)));
    twins.steps(3);
    twins.change(post, |post| post.set_collision_groups(OTHERS));
    twins.steps(3);
    twins.change(post, |post| post.set_translation_wrt_parent(at(0.0, 0.0)));
    assert!(twins.step().touches(cube, post));
    twins.steps(60);
}

#[test]
fn a_part_that_leaves_its_body_for_a_fixed_one() {
    let mut twins = Twins::heavy();
    twins.insert_floor();
    let (sleeper, whole) = twins.insert(dynamic(0.0, 0.5), cube());
    let part = twins.both(|world| {
        let part = cuboid([0.1; 3]).translation(at(0.5, 0.0));
        let World {
            colliders, bodies, ..
        } = world;
        colliders.insert_with_parent(part, sleeper, bodies)
    });
    let rock = twins.both(|world| world.bodies.insert(fixed(0.0, 0.5)));
    twins.step_until(|seen| seen.sleeps(sleeper));
    twins.both(|world| {
        let World {
            colliders, bodies, ..
        } = world;
        colliders.set_parent(part, Some(rock), bodies);
    });
    assert!(twins.step().touches(whole, part));
    twins.steps(10);
}
