//! Colliders and bodies that are removed while they touch others, and indices that are used again.

use super::rapier::prelude::*;
use super::twins::{Twins, cube, dynamic};

#[test]
fn removing_the_floor_wakes_what_sleeps_on_it() {
    for only_its_collider in [false, true] {
        let mut twins = Twins::heavy();
        let (floor_body, floor) = twins.insert_floor();
        let (body, cube) = twins.insert(dynamic(0.0, 0.5), cube());
        twins.step_until(|seen| seen.sleeps(body));
        twins.both(|world| match only_its_collider {
            true => world.remove_collider(floor),
            false => world.remove(floor_body),
        });
        let seen = twins.step();
        assert!(seen.stopped(cube, floor, true));
        assert!(!seen.sleeps(body));
        assert!(twins.steps(60).height(body) < 0.0);
    }
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
