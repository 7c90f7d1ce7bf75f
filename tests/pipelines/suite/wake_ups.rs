//! Changes of fixed bodies that sleeping neighbours must notice, or that Rapier lets them sleep through.
//!
//! Rapier wakes whatever has a pair with a changed collider, even a pair that filters have ruled out so far.

use super::World;
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};

const OTHERS: InteractionGroups = InteractionGroups::new(Group::GROUP_1, Group::GROUP_1);
const APART: InteractionGroups = InteractionGroups::new(Group::GROUP_2, Group::GROUP_2);

fn post() -> ColliderBuilder {
    cuboid([0.1, 2.0, 0.1])
}

#[test]
fn a_post_that_gets_another_group() {
    let mut twins = Twins::weightless();
    let cube = cube().collision_groups(OTHERS);
    let (sleeper, cube) = twins.insert(dynamic(0.0, 0.0), cube);
    let (_, post) = twins.insert(fixed(0.5, 0.0), post().collision_groups(APART));
    let seen = twins.step_until(|seen| seen.sleeps(sleeper));
    assert!(!seen.touches(cube, post));
    twins.change(post, |post| post.set_collision_groups(OTHERS));
    let seen = twins.step();
    assert!(seen.touches(cube, post));
    assert!(!seen.sleeps(sleeper));
}

#[test]
fn a_part_that_leaves_its_body_for_a_fixed_one() {
    let mut twins = Twins::weightless();
    let (sleeper, whole) = twins.insert(dynamic(0.0, 0.0), cube());
    let part = twins.both(|world| {
        let World {
            colliders, bodies, ..
        } = world;
        let part = cuboid([0.1; 3]).translation(at(0.5, 0.0));
        colliders.insert_with_parent(part, sleeper, bodies)
    });
    let rock = twins.both(|world| world.bodies.insert(fixed(0.0, 0.0)));
    twins.step_until(|seen| seen.sleeps(sleeper));
    twins.both(|world| {
        let World {
            colliders, bodies, ..
        } = world;
        colliders.set_parent(part, Some(rock), bodies);
    });
    let seen = twins.step();
    assert!(seen.touches(whole, part));
    assert!(!seen.sleeps(sleeper));
    twins.steps(10);
}

/// There is no pair yet when the post arrives, so Rapier wakes nothing either.
#[test]
fn a_post_that_comes_from_afar() {
    let mut twins = Twins::weightless();
    let (sleeper, cube) = twins.insert(dynamic(0.0, 0.0), cube());
    let (_, post) = twins.insert(fixed(20.0, 0.0), post());
    twins.step_until(|seen| seen.sleeps(sleeper));
    twins.change(post, |post| post.set_translation_wrt_parent(at(-19.5, 0.0)));
    let seen = twins.step();
    assert!(seen.touches(cube, post) && seen.sleeps(sleeper));
    twins.steps(60);
}
