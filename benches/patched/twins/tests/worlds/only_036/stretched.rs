//! Rotations that are not of unit length, which Rapier 0.36 keeps as they are.

use super::PairFilter;
use super::rapier::prelude::*;
use super::twins::{Twins, at, dynamic, fixed, spin};
use super::version::{origin, stretched};

#[test]
fn a_capsule_whose_rotation_is_not_of_unit_length() {
    for factor in [1.0 - 1.0e-4, 1.0 - 1.0e-3, 1.0 - 5.0e-3, 0.95] {
        let mut twins = Twins::with_filter(PairFilter::Shapes).without_gravity();
        let turned = fixed(0.0, 0.0).rotation(spin(0.8));
        let (body, capsule) = twins.insert(turned, ColliderBuilder::capsule_y(50.0, 0.5));
        let pose = *twins.ours.bodies[body].position();
        let axis = pose.rotation * at(0.0, 1.0);
        let ball = RigidBodyBuilder::dynamic().translation(axis * 52.0);
        let (_, ball) = twins.insert(ball.linvel(axis * -1.5), ColliderBuilder::ball(0.5));
        twins.change_body(body, |body| {
            body.set_position(stretched(pose, factor), true)
        });
        twins.step_until(|seen| seen.touches(capsule, ball));
        twins.steps(60);
    }
}

/// The boxes of balls do not show how they are turned.
#[test]
fn a_kinematic_ball_whose_next_rotation_is_not_of_unit_length() {
    let mut twins = Twins::with_filter(PairFilter::Shapes).without_gravity();
    let kinematic = RigidBodyBuilder::kinematic_position_based();
    let (body, moving) = twins.insert(kinematic, ColliderBuilder::ball(0.5));
    let (_, other) = twins.insert(dynamic(0.9, 0.9), ColliderBuilder::ball(0.5));
    assert!(!twins.steps(3).touches(moving, other));
    for factor in [0.7, 1.0, 0.7] {
        twins.change_body(body, |body| {
            let pose = stretched(*body.position(), factor);
            body.set_next_kinematic_position(pose);
        });
        let seen = twins.steps(2);
        assert!(factor == 1.0 || seen.touches(moving, other));
        assert_eq!(origin(twins.ours.bodies[body].position()), at(0.0, 0.0));
    }
}
