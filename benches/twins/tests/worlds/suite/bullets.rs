//! Fast bodies: continuous collision detection, hard and soft.

use super::rapier::prelude::*;
use super::twins::{Twins, at, cuboid, dynamic, spin};

/// Whether CCD is hard, and how far ahead soft CCD looks. What is faster than that may pass, but must do so in both worlds.
const KINDS: [(bool, Real); 7] = [
    (true, 0.0),
    (true, 0.5),
    (false, 0.1),
    (false, 0.5),
    (false, 1.0),
    (false, 2.0),
    (false, 20.0),
];

/// Shoots bodies at a thin wall, each in a lane of its own.
fn shoot(substeps: usize) {
    let mut twins = Twins::weightless();
    twins.both(|world| world.params.max_ccd_substeps = substeps);
    let (_, wall) = twins.insert(RigidBodyBuilder::fixed(), cuboid([0.02, 500.0, 30.0]));
    let mut bullets = Vec::new();
    let speeds = [30.0, 101.0, 150.0, 300.0, 3000.0];
    let shots = speeds
        .into_iter()
        .flat_map(|speed| KINDS.map(|kind| (speed, kind)));
    for (i, (speed, (is_hard, reach))) in shots.enumerate() {
        let bullet = dynamic(-10.0 - 0.1 * i as Real, 5.0 * i as Real)
            .linvel(at(speed, 1.0))
            .ccd_enabled(is_hard)
            .soft_ccd_prediction(reach);
        let (_, collider) = match is_hard || i % 2 == 0 {
            true => twins.insert(bullet, ColliderBuilder::ball(0.1)),
            false => twins.insert(bullet.angvel(spin(40.0)), cuboid([0.5, 0.1, 0.3])),
        };
        bullets.push(collider);
    }
    let mut hits = 0;
    for _ in 0..60 {
        let seen = twins.step();
        let has_hit = |&&bullet: &&ColliderHandle| seen.started(bullet, wall);
        hits += bullets.iter().filter(has_hit).count();
    }
    // Each with hard CCD.
    assert!(hits >= 2 * speeds.len(), "{hits} hits");
}

#[test]
fn bullets_and_a_thin_wall() {
    shoot(1);
}

/// Each substep is an update of its own; in Rapier 0.36, after boxes were handed over.
#[test]
fn several_substeps() {
    shoot(4);
}
