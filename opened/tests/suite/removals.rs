//! Colliders and bodies removed while they touch others, indices used again, and what must or must not wake.

use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};

#[test]
fn removing_the_floor_wakes_what_sleeps_on_it() {
    for only_its_collider in [false, true] {
        let mut twins = Twins::heavy();
        let (floor_body, floor) = twins.insert_floor();
        let (body, cube) = twins.insert(dynamic(0.0, 0.5), cube());
        twins.step_until(|seen| seen.sleeps(body));
        twins.both(|world| match only_its_collider {
            true => world.remove_collider(floor).is_some(),
            false => world.remove_body(floor_body).is_some(),
        });
        let seen = twins.step();
        assert!(seen.stopped(cube, floor, true));
        assert!(!seen.sleeps(body));
        assert!(twins.steps(60).height(body) < 0.0);
    }
}

#[test]
fn removing_a_body_in_contact() {
    let mut twins = Twins::heavy();
    let (_, floor) = twins.insert_floor();
    let (body, cube) = twins.insert(dynamic(0.0, 0.5), cube());
    assert!(twins.steps(5).touches(cube, floor));
    twins.both(|world| world.remove_body(body).is_some());
    let seen = twins.step();
    assert!(seen.stopped(cube, floor, true) && seen.contacts.is_empty());
}

#[test]
fn a_collider_outlives_its_body() {
    let mut twins = Twins::heavy();
    let (floor_body, floor) = twins.insert_floor();
    let (body, cube) = twins.insert(dynamic(0.0, 0.5), cube());
    assert!(twins.steps(5).touches(cube, floor));
    twins.both(|world| {
        world
            .remove_body_with_colliders(floor_body, false)
            .is_some()
    });
    assert!(twins.steps(5).touches(cube, floor));
    assert!(twins.step_until(|seen| seen.sleeps(body)).height(body) > 0.0);
}

/// The collider that had the index was moved by the last step, so its box was handed over and never looked at.
#[test]
fn an_index_used_again_at_once() {
    let mut twins = Twins::heavy();
    let (_, floor) = twins.insert_floor();
    let (mut body, mut last) = twins.insert(dynamic(0.0, 0.5), cube());
    for i in 0..6 {
        assert!(twins.steps(2).touches(last, floor));
        twins.both(|world| world.remove_body(body).is_some());
        let gone = last;
        (body, last) = twins.insert(dynamic(0.1 * i as Real, 0.5), cube());
        assert_eq!(gone.into_raw_parts().0, last.into_raw_parts().0);
        let seen = twins.step();
        assert!(seen.stopped(gone, floor, true) && seen.started(last, floor));
    }
}

/// Things come and go all the time, through gates that let them pass.
#[test]
fn a_stream() {
    let mut twins = Twins::weightless();
    let lane = |i: usize| 3.0 * (i % 12) as Real;
    for i in 0..12 {
        twins.insert(fixed(6.0, lane(i)), cube().sensor(true));
    }
    let thin = InteractionGroups::new(Group::GROUP_1, !Group::GROUP_1, InteractionTestMode::And);
    let mut flying = Vec::new();
    for i in 0..240 {
        let body = dynamic(0.0, lane(i * 5)).linvel(at(10.0, 0.0));
        let ball = ColliderBuilder::ball(0.4).collision_groups(thin);
        flying.push(twins.insert(body, ball).0);
        if i % 3 == 2 && flying.len() > 9 {
            let gone = flying.remove(i % 5);
            twins.both(|world| world.remove_body(gone).is_some());
        }
        twins.steps(5);
    }
}

/// Rapier wakes what it holds a pair with, whether the two touch or not.
#[test]
fn a_post_that_is_near_and_does_not_touch() {
    let changes: [fn(&mut PhysicsWorld, ColliderHandle); 3] = [
        |world, post| {
            world.remove_collider(post);
        },
        |world, post| world.colliders[post].set_translation_wrt_parent(at(0.001, 0.0)),
        |world, post| world.colliders[post].set_enabled(false),
    ];
    for (i, change) in changes.into_iter().enumerate() {
        for gap in [0.05, 0.5] {
            let mut twins = Twins::heavy();
            twins.insert_floor();
            let (body, cube) = twins.insert(dynamic(0.0, 0.6), cube());
            let (_, post) = twins.insert(fixed(0.6 + gap, 2.0), post());
            let seen = twins.step_until(|seen| seen.sleeps(body));
            assert!(!seen.touches(cube, post));
            twins.both(|world| change(world, post));
            let seen = twins.step();
            assert_eq!(seen.sleeps(body), gap > 0.1, "change {i}, gap {gap}");
            twins.steps(10);
        }
    }
}

fn groups(bits: Group) -> InteractionGroups {
    InteractionGroups::new(bits, bits, InteractionTestMode::And)
}

fn post() -> ColliderBuilder {
    cuboid([0.1, 2.0, 0.1])
}

#[test]
fn a_post_that_gets_another_group() {
    let mut twins = Twins::weightless();
    let cube = cube().collision_groups(groups(Group::GROUP_1));
    let (sleeper, cube) = twins.insert(dynamic(0.0, 0.0), cube);
    let post = post().collision_groups(groups(Group::GROUP_2));
    let (_, post) = twins.insert(fixed(0.5, 0.0), post);
    let seen = twins.step_until(|seen| seen.sleeps(sleeper));
    assert!(!seen.touches(cube, post));
    twins.change(post, |post| {
        post.set_collision_groups(groups(Group::GROUP_1))
    });
    twins.steps(10);
}

#[test]
fn a_post_that_comes_from_afar() {
    let mut twins = Twins::weightless();
    let (sleeper, _) = twins.insert(dynamic(0.0, 0.0), cube());
    let (_, post) = twins.insert(fixed(20.0, 0.0), post());
    twins.step_until(|seen| seen.sleeps(sleeper));
    twins.change(post, |post| {
        post.set_translation_wrt_parent(at(-19.5, 0.0));
    });
    twins.steps(60);
}

#[test]
fn a_part_that_leaves_its_body_for_a_fixed_one() {
    let mut twins = Twins::weightless();
    let (sleeper, _) = twins.insert(dynamic(0.0, 0.0), cube());
    let part = twins.insert_part(sleeper, cuboid([0.1; 3]).translation(at(0.5, 0.0)));
    let rock = twins.both(|world| world.insert_body(fixed(0.0, 0.0)));
    twins.step_until(|seen| seen.sleeps(sleeper));
    twins.set_parent(part, Some(rock));
    twins.steps(10);
}

/// What hits a sleeping body wakes it.
#[test]
fn a_ball_that_wakes_a_sleeper() {
    let mut twins = Twins::weightless();
    let (sleeper, _) = twins.insert(dynamic(0.0, 0.0), cube());
    twins.step_until(|seen| seen.sleeps(sleeper));
    twins.insert(
        dynamic(-5.0, 0.0).linvel(at(4.0, 0.0)),
        ColliderBuilder::ball(0.3),
    );
    twins.step_until(|seen| !seen.sleeps(sleeper));
    twins.steps(60);
}
