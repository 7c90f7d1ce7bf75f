//! Ropes in Rapier 0.36: capsules joined by spherical joints fall over a bar and tangle, on Rapier's own broad phase and on unisize.
//!
//! ```text
//! cargo run --release --bin rope
//! ```
//!
//! README.md says how to make the patched copy of Rapier first. A `Cargo.toml` of yours needs these lines below `[dependencies]`, with the
//! path to your clone of unisize:
//!
//! ```toml
//! rapier3d = "=0.36.1"
//! unisize = { path = "../unisize", features = ["rapier3d-036"] }
//! ```
//!
//! Prints the time of a step on either broad phase. Fails if a joint comes apart, if a rope falls through the floor, or if Rapier's own
//! broad phase finds other contacts than unisize.

use std::collections::HashSet;
use std::time::{Duration, Instant};

use rapier3d::prelude::*;
use unisize::rapier3d_036::UnisizeBroadPhase;

const ROPES: usize = 60;
const SEGMENTS: usize = 40;
/// Half the distance between the two joints of a segment.
const HALF: f32 = 0.25;
const STEPS: usize = 300;

fn ropes() -> PhysicsWorld {
    let mut world = PhysicsWorld::default();
    let floor = ColliderBuilder::cuboid(30.0, 1.0, 30.0).translation(Vector::new(0.0, -1.0, 0.0));
    world.colliders.insert(floor);
    let bar = ColliderBuilder::capsule_z(20.0, 0.3).translation(Vector::new(0.0, 5.0, 0.0));
    world.colliders.insert(bar);
    // Three layers of twenty ropes, which lie along the x axis.
    for rope in 0..ROPES {
        let (layer, place) = ((rope / 20) as f32, (rope % 20) as f32);
        let x = -HALF * SEGMENTS as f32 + 0.3 * layer;
        let start = Vector::new(x, 6.0 + 0.5 * layer, place - 10.0);
        let mut previous = None;
        for segment in 0..SEGMENTS {
            let center = start + Vector::X * (HALF * (2 * segment + 1) as f32);
            let body = RigidBodyBuilder::dynamic().translation(center);
            let (body, _) = world.insert(body, ColliderBuilder::capsule_x(HALF, 0.1));
            if let Some(previous) = previous {
                let joint = SphericalJointBuilder::new()
                    .local_anchor1(Vector::new(HALF, 0.0, 0.0))
                    .local_anchor2(Vector::new(-HALF, 0.0, 0.0))
                    .contacts_enabled(false);
                world.insert_impulse_joint(previous, body, joint);
            }
            previous = Some(body);
        }
    }
    world
}

/// The indices of the colliders that touch where they are now. Joints do not count here: neighbors on a rope touch, too.
fn contacts(world: &mut PhysicsWorld) -> HashSet<[u32; 2]> {
    // Pairs of sleeping bodies are not tested.
    world.wake_up_all(true);
    world.detect_collisions(&(), &());
    let pairs = world.contact_pairs();
    let touching = pairs.filter(|pair| pair.has_any_active_contact());
    let indices = touching.map(|pair| {
        let mut indices = [pair.collider1, pair.collider2].map(|it| it.into_raw_parts().0);
        indices.sort_unstable();
        indices
    });
    indices.collect()
}

fn main() {
    let mut unisize = ropes();
    // The only line that changes.
    unisize.broad_phase = DefaultBroadPhase::custom(UnisizeBroadPhase::new());

    let mut worlds = [("Rapier's own", ropes()), ("unisize", unisize)];
    let mut times = [Duration::ZERO; 2];
    // The worlds take turns, so that other load on the machine slows both down alike.
    for _ in 0..STEPS {
        for ((_, world), time) in worlds.iter_mut().zip(&mut times) {
            let start = Instant::now();
            world.step();
            *time += start.elapsed();
        }
    }
    for ((name, world), time) in worlds.iter().zip(times) {
        // The distance between the two anchors of each joint.
        let gaps = world.impulse_joints.iter().map(|(_, joint)| {
            let bodies = [joint.body1(), joint.body2()];
            let [body1, body2] = bodies.map(|body| world.bodies[body].position());
            let (anchor1, anchor2) = (joint.data.local_anchor1(), joint.data.local_anchor2());
            (body1 * anchor1 - body2 * anchor2).length()
        });
        let gap = gaps.fold(0.0, f32::max);
        let heights = world.bodies.iter().map(|(_, body)| body.translation().y);
        let lowest = heights.fold(f32::INFINITY, f32::min);
        let ms = time.as_secs_f64() * 1e3 / STEPS as f64;
        println!("{name:>12}: {ms:.3} ms per step; the widest gap at a joint is {gap:.3}");
        assert!(gap < HALF, "a joint has come apart");
        assert!(lowest > -0.2, "a rope has fallen through the floor");
    }

    let [_, (_, world)] = &mut worlds;
    let found = contacts(world);
    // Another broad phase may take over a running world: here, Rapier's own.
    world.broad_phase = DefaultBroadPhase::new();
    assert!(contacts(world) == found, "the contacts are others");
    println!("both broad phases find the same {} contacts", found.len());
}
