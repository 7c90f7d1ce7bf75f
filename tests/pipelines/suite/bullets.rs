//! Fast bodies: continuous collision detection, hard and soft.

use super::rapier::prelude::*;
use super::spin;
use super::twins::{Twins, at, cuboid, dynamic};

/// Shoots a body at a thin wall; it must hit and stay on its side.
fn shoot(bullet: RigidBodyBuilder, shape: ColliderBuilder) {
    let mut twins = Twins::weightless();
    let wall = cuboid([0.02, 30.0, 30.0]);
    let (_, wall) = twins.insert(RigidBodyBuilder::fixed(), wall);
    let (body, bullet) = twins.insert(bullet.translation(at(-10.0, 0.0)), shape);
    let mut has_hit = false;
    for _ in 0..60 {
        has_hit |= twins.step().started(bullet, wall);
        assert!(twins.ours.bodies[body].translation().x < 0.02);
    }
    assert!(has_hit);
}

#[test]
fn ccd_bullet() {
    for speed in [30.0, 300.0, 3000.0] {
        let bullet = RigidBodyBuilder::dynamic().linvel(at(speed, 0.0));
        shoot(bullet.ccd_enabled(true), ColliderBuilder::ball(0.1));
    }
}

#[test]
fn soft_ccd_bullet() {
    for speed in [30.0, 120.0, 300.0] {
        let bullet = RigidBodyBuilder::dynamic().linvel(at(speed, 0.0));
        shoot(bullet.soft_ccd_prediction(20.0), ColliderBuilder::ball(0.1));
    }
}

#[test]
fn spinning_soft_ccd_bullet() {
    for speed in [10.0, 60.0, 150.0] {
        let bullet = RigidBodyBuilder::dynamic().linvel(at(speed, 1.0));
        let bullet = bullet.angvel(spin(40.0)).soft_ccd_prediction(20.0);
        shoot(bullet, cuboid([0.5, 0.1, 0.3]));
    }
}

#[test]
fn short_soft_ccd_predictions() {
    // The prediction is shorter than the step of the body: it may pass, but must do so in both worlds.
    for reach in [0.1, 0.5, 1.0, 2.0] {
        for lane in 0..5 {
            let mut twins = Twins::weightless();
            let speed = 40.0 + 61.0 * lane as Real;
            twins.insert(RigidBodyBuilder::fixed(), cuboid([0.02, 30.0, 30.0]));
            let bullet = dynamic(-10.0 - 0.7 * lane as Real, 0.0).linvel(at(speed, 2.0));
            let bullet = bullet.angvel(spin(20.0)).soft_ccd_prediction(reach);
            twins.insert(bullet, cuboid([0.3, 0.1, 0.3]));
            twins.steps(40);
        }
    }
}

/// With several, each substep is an update of its own; in Rapier 0.36, after boxes were handed over.
fn substeps(most: usize) {
    let mut twins = Twins::weightless();
    twins.both(|world| world.params.max_ccd_substeps = most);
    let (_, wall) = twins.insert(RigidBodyBuilder::fixed(), cuboid([0.02, 100.0, 30.0]));
    let mut bullets = Vec::new();
    for lane in 0..8 {
        let speed = 50.0 + 37.0 * lane as Real;
        let bullet = dynamic(-10.0, 5.0 * lane as Real).linvel(at(speed, 0.0));
        let bullet = match lane % 3 {
            0 => bullet.ccd_enabled(true),
            1 => bullet.soft_ccd_prediction(10.0),
            _ => bullet.ccd_enabled(true).soft_ccd_prediction(0.5),
        };
        bullets.push(twins.insert(bullet, ColliderBuilder::ball(0.1)).1);
    }
    let mut hits = 0;
    for _ in 0..30 {
        let seen = twins.step();
        let hit = |&&bullet: &&ColliderHandle| seen.started(bullet, wall);
        hits += bullets.iter().filter(hit).count();
    }
    assert!(hits >= bullets.len());
}

#[test]
fn all_kinds_together() {
    substeps(1);
}

#[test]
fn several_ccd_substeps() {
    substeps(4);
}
