//! A pile of particles in Rapier 0.36: balls are poured into a box, on Rapier's own broad phase and on unisize.
//!
//! ```text
//! cargo run --release --bin pile -- 8000
//! ```
//!
//! The number of particles is optional. README.md says how to make the patched copy of Rapier first. A `Cargo.toml` of yours needs these
//! lines below `[dependencies]`, with the path to your clone of unisize:
//!
//! ```toml
//! oorandom = "11"
//! rapier3d = "=0.36.1"
//! unisize = { path = "../unisize", features = ["rapier3d-036"] }
//! ```
//!
//! Prints the time of a step on either broad phase, while the particles fall and once they have settled. Fails if a particle leaves the
//! box, or if two particles overlap and are not a pair of the narrow phase.

use std::time::{Duration, Instant};

use rapier3d::prelude::*;
use unisize::rapier3d_036::UnisizeBroadPhase;

const RADIUS: f32 = 0.2;
/// Half the width of the box.
const HALF: f32 = 4.0;
const STEPS: usize = 360;

fn pile(particles: usize) -> PhysicsWorld {
    let mut world = PhysicsWorld::default();
    // A floor and four walls, which face inwards.
    let floor = ColliderBuilder::new(SharedShape::halfspace(Vector::Y));
    world.colliders.insert(floor);
    for inwards in [Vector::X, Vector::NEG_X, Vector::Z, Vector::NEG_Z] {
        let wall = ColliderBuilder::new(SharedShape::halfspace(inwards));
        world.colliders.insert(wall.translation(inwards * -HALF));
    }
    let mut random = oorandom::Rand32::new(1);
    let spacing = 2.2 * RADIUS;
    let side = (2.0 * HALF / spacing) as usize - 1;
    for i in 0..particles {
        let (x, y, z) = (i % side, i / (side * side), i / side % side);
        let cell = Vector::new(x as f32 + 0.5, y as f32 + 1.0, z as f32 + 0.5);
        // Off the lattice, so that the layers do not rest on each other like columns.
        let mut jitter = || 0.1 * RADIUS * random.rand_float();
        let jitter = Vector::new(jitter(), jitter(), jitter());
        let corner = Vector::new(RADIUS - HALF, 0.0, RADIUS - HALF);
        let body = RigidBodyBuilder::dynamic().translation(corner + cell * spacing + jitter);
        world.insert(body, ColliderBuilder::ball(RADIUS));
    }
    world
}

fn main() {
    let particles = std::env::args().nth(1);
    let particles = particles.map_or(4000, |count| count.parse().expect("a number of particles"));
    let mut unisize = pile(particles);
    // The only line that changes.
    unisize.broad_phase = DefaultBroadPhase::custom(UnisizeBroadPhase::new());

    let mut worlds = [("Rapier's own", pile(particles)), ("unisize", unisize)];
    let mut times = [[Duration::ZERO; 2]; 2];
    // The worlds take turns, so that other load on the machine slows both down alike.
    for step in 0..STEPS {
        for ((_, world), times) in worlds.iter_mut().zip(&mut times) {
            let start = Instant::now();
            world.step();
            times[2 * step / STEPS] += start.elapsed();
        }
    }

    for ((name, world), times) in worlds.iter_mut().zip(times) {
        let [falling, lying] = times.map(|time| time.as_secs_f64() * 2e3 / STEPS as f64);
        let pairs = world.contact_pairs();
        let contacts = pairs.filter(|pair| pair.has_any_active_contact()).count();
        println!(
            "{name:>12}: {falling:.2} ms per step in the first three seconds, {lying:.2} in the next three; {contacts} contacts"
        );
        // Brings the pairs up to date with the last step, which has moved the particles.
        world.detect_collisions(&(), &());
        let balls = world.colliders.iter();
        let balls: Vec<_> = balls.filter(|(_, ball)| ball.parent().is_some()).collect();
        for (i, (handle1, ball1)) in balls.iter().enumerate() {
            let center = ball1.translation();
            // At most half of a particle may be in a wall.
            let is_inside = center.x.abs() < HALF && center.z.abs() < HALF && center.y > 0.0;
            assert!(is_inside, "a particle has left the box");
            for (handle2, ball2) in &balls[..i] {
                let is_apart = (center - ball2.translation()).length() >= 2.0 * RADIUS;
                let is_pair = || world.contact_pair(*handle1, *handle2).is_some();
                assert!(is_apart || is_pair(), "a pair is missing");
            }
        }
    }
}
