//! Worlds with numbers that no sound program has: the same as with Rapier's own, and no panic.

use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed};
use super::version::unit;

/// Rapier takes bodies out of a world whose pose is not finite.
#[test]
fn poses_that_are_not_finite() {
    for (x, y) in [
        (Real::NAN, 0.0),
        (0.0, Real::INFINITY),
        (Real::NEG_INFINITY, Real::NAN),
    ] {
        let mut twins = Twins::heavy();
        let (_, floor) = twins.insert_floor();
        let (body, _) = twins.insert(dynamic(0.0, 0.5), cube());
        let (_, other) = twins.insert(dynamic(5.0, 0.5), cube());
        twins.steps(3);
        twins.change_body(body, |body| body.set_translation(at(x, y), true));
        assert!(twins.steps(5).touches(other, floor));
    }
}

#[test]
fn places_far_away_and_sizes_of_all_kinds() {
    let mut twins = Twins::weightless();
    for i in 0..12 {
        let x = 10.0_f64.powi(i) as Real;
        twins.insert(
            dynamic(x, 0.0).linvel(at(0.0, 1.0)),
            ColliderBuilder::ball(0.5),
        );
        twins.insert(fixed(-x, 0.0), cuboid([0.3 * x, 1.0e-3, 1.0]));
    }
    twins.insert(
        fixed(0.0, -50.0),
        ColliderBuilder::new(SharedShape::halfspace(unit(at(0.0, 1.0)))),
    );
    twins.steps(30);
}
