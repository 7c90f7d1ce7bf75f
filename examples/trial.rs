//! Has unisize the same pairs in your scene? `Trial` replaces the broad phase of your program for some hundred steps, and compares both.
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example trial
//! ```
//!
//! This is Rapier 0.27; `examples/patched/src/bin/trial.rs` does the same in 0.36. Rapier's own broad phase still drives the world, which
//! moves as before, bit for bit. unisize receives the same input at each filter level. Prints the report. Fails if unisize's pairs are not
//! Rapier's.

use rapier3d::prelude::*;
use unisize::rapier3d_027::Trial;

const STEPS: usize = 300;

fn main() {
    // Your scene instead.
    let mut bodies = RigidBodySet::new();
    let mut colliders = ColliderSet::new();
    colliders.insert(ColliderBuilder::cuboid(30.0, 0.5, 30.0));
    for i in 0..3000 {
        let (x, y, z) = (i % 15, i / 225, i / 15 % 15);
        let position = vector![x as f32 * 1.1, 1.5 + y as f32 * 1.1, z as f32 * 1.1];
        let body = bodies.insert(RigidBodyBuilder::dynamic().translation(position));
        colliders.insert_with_parent(ColliderBuilder::ball(0.5), body, &mut bodies);
    }

    // The only line that changes. It was `DefaultBroadPhase::new()`.
    let mut broad_phase = Trial::new();

    let mut pipeline = PhysicsPipeline::new();
    let mut islands = IslandManager::new();
    let mut narrow_phase = NarrowPhase::new();
    let mut impulse_joints = ImpulseJointSet::new();
    let mut multibody_joints = MultibodyJointSet::new();
    let mut ccd_solver = CCDSolver::new();
    for _ in 0..STEPS {
        pipeline.step(
            &vector![0.0, -9.81, 0.0],
            &IntegrationParameters::default(),
            &mut islands,
            &mut broad_phase,
            &mut narrow_phase,
            &mut bodies,
            &mut colliders,
            &mut impulse_joints,
            &mut multibody_joints,
            &mut ccd_solver,
            &(),
            &(),
        );
    }

    let report = broad_phase.report();
    println!("{report}");
    assert!(report.pairs_match(), "the pairs are not Rapier's own");
}
