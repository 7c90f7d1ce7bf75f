//! Colliders that are told apart by their boxes alone.

use super::rapier::prelude::*;
use super::twins::{Twins, at, dynamic, fixed};
use super::{PairFilter, World};

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
