//! A pile of particles: balls are poured into a box, once on Rapier's own broad phase and once on unisize.
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example particles3d -- 8000
//! ```
//!
//! The number of particles is optional. This is Rapier 0.27; `examples/patched/src/bin/pile.rs` does the same in 0.36. Prints the time
//! of a step on either broad phase, while the particles fall and once they have settled. Fails if a particle leaves the box.

use std::time::{Duration, Instant};

use rapier3d::prelude::*;
use unisize::rapier3d_027::UnisizeBroadPhase;

const RADIUS: f32 = 0.2;
/// Half the width of the box.
const HALF: f32 = 4.0;
const STEPS: usize = 360;

fn main() {
    let particles = std::env::args().nth(1);
    let particles = particles.map_or(4000, |count| count.parse().expect("a number of particles"));
    run("Rapier's own", particles, &mut DefaultBroadPhase::new());
    run("unisize", particles, &mut UnisizeBroadPhase::new());
}

fn run(name: &str, particles: usize, broad_phase: &mut dyn BroadPhase) {
    let mut bodies = RigidBodySet::new();
    let mut colliders = ColliderSet::new();
    // A floor and four walls, which face inwards.
    colliders.insert(ColliderBuilder::halfspace(Vector::y_axis()));
    for inwards in [Vector::x(), -Vector::x(), Vector::z(), -Vector::z()] {
        let wall = ColliderBuilder::halfspace(UnitVector::new_unchecked(inwards));
        colliders.insert(wall.translation(inwards * -HALF));
    }
    let mut random = oorandom::Rand32::new(1);
    let spacing = 2.2 * RADIUS;
    let side = (2.0 * HALF / spacing) as usize - 1;
    for i in 0..particles {
        let (x, y, z) = (i % side, i / (side * side), i / side % side);
        let cell = vector![x as f32 + 0.5, y as f32 + 1.0, z as f32 + 0.5];
        // Off the lattice, so that the layers do not rest on each other like columns.
        let jitter = Vector::from_fn(|_, _| 0.1 * RADIUS * random.rand_float());
        let corner = vector![RADIUS - HALF, 0.0, RADIUS - HALF];
        let position = corner + cell * spacing + jitter;
        let body = bodies.insert(RigidBodyBuilder::dynamic().translation(position));
        colliders.insert_with_parent(ColliderBuilder::ball(RADIUS), body, &mut bodies);
    }

    let mut pipeline = PhysicsPipeline::new();
    let mut islands = IslandManager::new();
    let mut narrow_phase = NarrowPhase::new();
    let mut impulse_joints = ImpulseJointSet::new();
    let mut multibody_joints = MultibodyJointSet::new();
    let mut ccd_solver = CCDSolver::new();
    let mut times = [Duration::ZERO; 2];
    for step in 0..STEPS {
        let start = Instant::now();
        pipeline.step(
            &vector![0.0, -9.81, 0.0],
            &IntegrationParameters::default(),
            &mut islands,
            broad_phase,
            &mut narrow_phase,
            &mut bodies,
            &mut colliders,
            &mut impulse_joints,
            &mut multibody_joints,
            &mut ccd_solver,
            &(),
            &(),
        );
        times[2 * step / STEPS] += start.elapsed();
    }

    let [falling, lying] = times.map(|time| time.as_secs_f64() * 2e3 / STEPS as f64);
    let pairs = narrow_phase.contact_pairs();
    let contacts = pairs.filter(|pair| pair.has_any_active_contact).count();
    println!(
        "{name:>12}: {falling:.2} ms per step in the first three seconds, {lying:.2} in the next three; {contacts} contacts"
    );
    for (_, body) in bodies.iter() {
        let position = body.translation();
        // At most half of a particle may be in a wall.
        let is_inside = position.x.abs() < HALF && position.z.abs() < HALF && position.y > 0.0;
        assert!(is_inside, "a particle has left the box");
    }
}
