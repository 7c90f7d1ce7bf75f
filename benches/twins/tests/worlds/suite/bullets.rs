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

/// Up to 512 fixed colliders, Rapier 0.36 has a list of them for what is fast, and beyond that asks the tree of the broad phase.
#[test]
fn fixed_colliders_around_the_limit_of_a_list() {
    for count in [511, 512, 513] {
        let mut twins = Twins::weightless();
        let posts = (0..count).map(|i| {
            // So far apart that nothing hits two in a step, for the tree decides which of them is looked at first.
            let place = at(15.0 * (i % 32) as Real, 2.0 * (i / 32) as Real);
            let post = RigidBodyBuilder::fixed().translation(place);
            twins.insert(post, cuboid([0.02, 0.5, 0.5]))
        });
        let posts: Vec<_> = posts.collect();
        let bullets = (0..17).map(|lane| {
            let bullet = dynamic(-1.0 - 0.1 * lane as Real, 2.0 * lane as Real)
                .linvel(at(400.0 + 30.0 * lane as Real, 0.0))
                .ccd_enabled(lane % 2 == 0);
            twins.insert(bullet, ColliderBuilder::ball(0.1).restitution(0.5))
        });
        let bullets: Vec<_> = bullets.collect();
        let mut hits = 0;
        for step in 0..20 {
            // The limit is crossed, and crossed back.
            match step {
                8 => twins.remove(posts[40].0),
                9 => twins.remove(posts[70].0),
                12 | 13 => {
                    let place = at(-10.0, 2.0 * step as Real);
                    let post = RigidBodyBuilder::fixed().translation(place);
                    twins.insert(post, cuboid([0.02, 0.5, 0.5]));
                }
                _ => {}
            }
            for &(bullet, _) in bullets.iter().skip(step % 5).step_by(5) {
                twins.change_body(bullet, |bullet| bullet.set_linvel(at(500.0, 0.0), true));
            }
            hits += twins.step().contacts.len();
        }
        assert!(hits > 16, "{hits} hits");
    }
}
