//! Colliders and bodies removed while they touch others, indices used again, and things that come and go all the time.

use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, dynamic, fixed};
use super::version::{self, remove_body_alone, remove_collider};

#[test]
fn removing_the_floor_wakes_what_sleeps_on_it() {
    for only_its_collider in [false, true] {
        let mut twins = Twins::heavy();
        let (floor_body, floor) = twins.insert_floor();
        let (body, cube) = twins.insert(dynamic(0.0, 0.5), cube());
        twins.step_until(|seen| seen.sleeps(body));
        twins.both(|world| match only_its_collider {
            true => remove_collider(world, floor),
            false => world.remove(floor_body),
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
    twins.remove(body);
    let seen = twins.step();
    assert!(seen.stopped(cube, floor, true) && seen.contacts.is_empty());
}

#[test]
fn a_collider_outlives_its_body() {
    let mut twins = Twins::heavy();
    let (floor_body, floor) = twins.insert_floor();
    let (body, cube) = twins.insert(dynamic(0.0, 0.5), cube());
    assert!(twins.steps(5).touches(cube, floor));
    twins.both(|world| remove_body_alone(world, floor_body));
    assert!(twins.steps(5).touches(cube, floor));
    assert!(twins.step_until(|seen| seen.sleeps(body)).height(body) > 0.0);
}

/// In Rapier 0.36, the collider that had the index was moved by the last step, so its box was handed over and never looked at.
#[test]
fn an_index_used_again_at_once() {
    let mut twins = Twins::heavy();
    let (_, floor) = twins.insert_floor();
    let (mut body, mut last) = twins.insert(dynamic(0.0, 0.5), cube());
    for i in 0..6 {
        assert!(twins.steps(2).touches(last, floor));
        twins.remove(body);
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
    let thin = version::groups(Group::GROUP_1, !Group::GROUP_1);
    let mut flying = Vec::new();
    for i in 0..240 {
        let body = dynamic(0.0, lane(i * 5)).linvel(at(10.0, 0.0));
        let ball = ColliderBuilder::ball(0.4).collision_groups(thin);
        flying.push(twins.insert(body, ball).0);
        if i % 3 == 2 && flying.len() > 9 {
            let gone = flying.remove(i % 5);
            twins.remove(gone);
        }
        twins.steps(5);
    }
}
