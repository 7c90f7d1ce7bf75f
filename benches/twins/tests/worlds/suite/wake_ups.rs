//! Changes of fixed bodies that sleeping neighbours must notice, or that Rapier lets them sleep through.
//!
//! Rapier wakes whatever has a pair with a changed collider, even a pair that filters have ruled out so far.

use super::World;
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};
use super::{scenes, version};

fn groups(bits: Group) -> InteractionGroups {
    scenes::groups(bits, bits)
}

fn post() -> ColliderBuilder {
    cuboid([0.1, 2.0, 0.1])
}

#[test]
fn a_post_that_gets_another_group() {
    let mut twins = Twins::weightless();
    let cube = cube().collision_groups(groups(Group::GROUP_1));
    let (sleeper, cube) = twins.insert(dynamic(0.0, 0.0), cube);
    let (_, post) = twins.insert(
        fixed(0.5, 0.0),
        post().collision_groups(groups(Group::GROUP_2)),
    );
    let seen = twins.step_until(|seen| seen.sleeps(sleeper));
    assert!(!seen.touches(cube, post));
    twins.change(post, |post| {
        post.set_collision_groups(groups(Group::GROUP_1))
    });
    let seen = twins.step();
    assert!(seen.touches(cube, post));
    assert!(!seen.sleeps(sleeper));
}

#[test]
fn a_part_that_leaves_its_body_for_a_fixed_one() {
    let mut twins = Twins::weightless();
    let (sleeper, whole) = twins.insert(dynamic(0.0, 0.0), cube());
    let part = twins.insert_part(sleeper, cuboid([0.1; 3]).translation(at(0.5, 0.0)));
    let rock = twins.both(|world| world.bodies.insert(fixed(0.0, 0.0)));
    twins.step_until(|seen| seen.sleeps(sleeper));
    twins.set_parent(part, Some(rock));
    let seen = twins.step();
    assert!(seen.touches(whole, part));
    assert!(!seen.sleeps(sleeper));
    twins.steps(10);
}

/// Rapier wakes what it holds a pair with, whether the two touch or not.
#[test]
fn a_post_that_is_near_and_does_not_touch() {
    let changes: [fn(&mut World, ColliderHandle); 3] = [
        World::remove_collider,
        |world, post| world.colliders[post].set_translation_wrt_parent(at(0.001, 0.0)),
        |world, post| world.colliders[post].set_enabled(false),
    ];
    for (i, change) in changes.into_iter().enumerate() {
        for gap in [version::NEAR, 0.5] {
            let mut twins = Twins::heavy();
            twins.insert_floor();
            let (body, cube) = twins.insert(dynamic(0.0, 0.6), cube());
            let (_, post) = twins.insert(fixed(0.6 + gap, 2.0), post());
            let seen = twins.step_until(|seen| seen.sleeps(body));
            assert!(!seen.touches(cube, post));
            twins.both(|world| change(world, post));
            let seen = twins.step();
            assert_eq!(
                seen.sleeps(body),
                gap > version::NEAR,
                "change {i}, gap {gap}"
            );
            twins.steps(10);
        }
    }
}
