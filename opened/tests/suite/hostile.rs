//! Numbers and orders of events that no sane program has: the same as with Rapier's own, and no panic.

use super::UnisizeBroadPhase;
use super::rapier::prelude::*;
use super::twins::{Twins, at, cube, cuboid, dynamic, fixed, unisize, world_with};

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
fn velocities_that_are_not_finite() {
    for speed in [Real::NAN, Real::INFINITY, Real::MAX, 1.0e30] {
        let mut twins = Twins::weightless();
        let (_, other) = twins.insert(dynamic(5.0, 0.5), cube());
        let (_, post) = twins.insert(fixed(5.9, 0.5), cube());
        let (body, _) = twins.insert(dynamic(0.0, 0.5), cube());
        twins.steps(3);
        twins.change_body(body, |body| body.set_linvel(at(speed, 0.0), true));
        for _ in 0..5 {
            twins.step();
        }
        let _ = (other, post);
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
        ColliderBuilder::new(SharedShape::halfspace(Vector::Y)),
    );
    twins.steps(30);
}

/// A step of no length, and steps of another length.
#[test]
fn lengths_of_steps() {
    let mut twins = Twins::heavy();
    twins.insert_floor();
    let (_, ball) = twins.insert(dynamic(0.0, 2.0), ColliderBuilder::ball(0.5));
    for dt in [0.0, 1.0 / 60.0, 0.0, 0.1, 1.0e-5, 1.0 / 240.0] {
        twins.both(|world| world.integration_parameters.dt = dt);
        twins.steps(20);
    }
    let _ = ball;
}

#[test]
fn other_length_units() {
    for unit in [0.01, 100.0] {
        let mut twins = Twins::heavy();
        twins.both(|world| world.integration_parameters.length_unit = unit);
        twins.insert_floor();
        twins.insert(dynamic(0.0, 2.0), ColliderBuilder::ball(0.5));
        twins.steps(90);
    }
}

/// Handles that the world does not know, and boxes that are none: Rapier's own must not be asked, but ours takes them.
#[test]
fn boxes_for_nobody() {
    let params = IntegrationParameters::default();
    let mut world = world_with(UnisizeBroadPhase::new());
    let (body, _) = world.insert(dynamic(0.0, 0.0), cube());
    let sound = Aabb::new(at(-0.5, -0.5), at(0.5, 0.5));
    let nan = Aabb::new(at(Real::NAN, 0.0), at(0.0, 0.0));
    for step in 0..20 {
        for (index, generation) in [(0, 7), (3, 0), (u32::MAX, 0), (u32::MAX, u32::MAX)] {
            let handle = ColliderHandle::from_raw_parts(index, generation);
            let aabb = if step % 3 == 0 { nan } else { sound };
            world.broad_phase.set_aabb(&params, handle, aabb);
        }
        unisize(&world).validate();
        world.step();
        unisize(&world).validate();
        assert_eq!(unisize(&world).stats().proxies, 1);
    }
    assert!(world.bodies[body].translation().y < 0.0);
}
