//! Colliders and bodies removed while they touch others, and indices used again.

use super::World;
use super::rapier::prelude::*;
use super::twins::{Twins, cube, dynamic};

#[test]
fn removing_the_floor_wakes_what_sleeps_on_it() {
    let mut twins = Twins::heavy();
    let (floor_body, floor) = twins.insert_floor();
    let (body, cube) = twins.insert(dynamic(0.0, 0.5), cube());
    twins.step_until(|seen| seen.sleeps(body));
    twins.both(|world| world.remove(floor_body));
    let seen = twins.step();
    assert!(seen.stopped(cube, floor, true));
    assert!(!seen.sleeps(body));
    assert!(twins.steps(60).height(body) < 0.0);
}

#[test]
fn removing_one_collider_of_the_floor() {
    let mut twins = Twins::heavy();
    let (_, floor) = twins.insert_floor();
    let (body, cube) = twins.insert(dynamic(0.0, 0.5), cube());
    twins.step_until(|seen| seen.sleeps(body));
    twins.both(|world| {
        let World {
            colliders,
            islands,
            bodies,
            ..
        } = world;
        colliders.remove(floor, islands, bodies, true).is_some()
    });
    let seen = twins.step();
    assert!(seen.stopped(cube, floor, true) && !seen.sleeps(body));
}

#[test]
fn removing_a_body_in_contact() {
    let mut twins = Twins::heavy();
    let (_, floor) = twins.insert_floor();
    let (body, cube) = twins.insert(dynamic(0.0, 0.5), cube());
    assert!(twins.steps(5).touches(cube, floor));
    twins.both(|world| world.remove(body));
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
        world.bodies.remove(
            floor_body,
            &mut world.islands,
            &mut world.colliders,
            &mut world.impulse_joints,
            &mut world.multibody_joints,
            false,
        );
    });
    assert!(twins.steps(5).touches(cube, floor));
    assert!(twins.step_until(|seen| seen.sleeps(body)).height(body) > 0.0);
}

#[test]
fn an_index_used_again_at_once() {
    let mut twins = Twins::heavy();
    let (_, floor) = twins.insert_floor();
    let (mut body, mut last) = twins.insert(dynamic(0.0, 0.5), cube());
    for i in 0..6 {
        assert!(twins.steps(2).touches(last, floor));
        twins.both(|world| world.remove(body));
        let gone = last;
        (body, last) = twins.insert(dynamic(0.1 * i as Real, 0.5), cube());
        assert_eq!(gone.into_raw_parts().0, last.into_raw_parts().0);
        let seen = twins.step();
        assert!(seen.stopped(gone, floor, true) && seen.started(last, floor));
    }
}
