//! A pile of balls and boxes in Rapier 0.36, on Rapier's own broad phase and on unisize. One line differs.
//!
//! ```text
//! cargo run --release
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
//! Prints the time of a step on either broad phase. Fails if unisize is not active, or if a body falls through the floor.

use std::time::{Duration, Instant};

use rapier3d::prelude::*;
use unisize::rapier3d_036::UnisizeBroadPhase;

const BODIES: usize = 3000;
const STEPS: usize = 300;

fn pile() -> PhysicsWorld {
    let mut world = PhysicsWorld::default();
    let floor = ColliderBuilder::cuboid(90.0, 1.0, 90.0).translation(Vector::new(0.0, -1.0, 0.0));
    world.colliders.insert(floor);
    for i in 0..BODIES {
        let (x, y, z) = (i % 12, i / 144, i / 12 % 12);
        let shift = 0.05 * (y % 3) as f32;
        let position = Vector::new(x as f32 + shift, 1.0 + y as f32, z as f32) * 1.1;
        let body = RigidBodyBuilder::dynamic().translation(position);
        let collider = match i % 2 {
            0 => ColliderBuilder::ball(0.5),
            _ => ColliderBuilder::cuboid(0.4, 0.4, 0.4),
        };
        world.insert(body, collider);
    }
    world
}

fn main() {
    let mut unisize = pile();
    // The only line that changes. It was `DefaultBroadPhase::new()`, which is the default.
    unisize.broad_phase = DefaultBroadPhase::custom(UnisizeBroadPhase::new());

    let mut worlds = [("Rapier's own", pile()), ("unisize", unisize)];
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
        let pairs = world.narrow_phase.contact_pairs().count();
        let ms = time.as_secs_f64() * 1e3 / STEPS as f64;
        println!("{name:>12}: {ms:.2} ms per step, {pairs} pairs in the narrow phase");
        let heights = world.bodies.iter().map(|(_, body)| body.translation().y);
        let lowest = heights.fold(f32::INFINITY, f32::min);
        assert!(lowest > 0.0, "a body is below the floor");
    }

    // This is how a program sees that unisize is active.
    let [_, (_, world)] = &worlds;
    let active = world.broad_phase.custom_ref::<UnisizeBroadPhase>();
    let stats = active.expect("unisize is not active").stats();
    assert_eq!(stats.refused, 0, "some colliders have no valid box");
    println!(
        "unisize holds {} pairs of {} colliders",
        stats.pairs, stats.proxies
    );

    // Queries are called as before.
    let ray = Ray::new(Vector::new(-50.0, 5.0, 0.0), -Vector::Y);
    let hit = world.cast_ray(&ray, 10.0, true, QueryFilter::default());
    let (_, distance) = hit.expect("the floor is below the ray");
    println!("a ray hits the floor at a distance of {distance:.2}");
}
