//! The smallest program for Rapier 0.27: a thousand balls fall onto a floor. One line differs from a program without unisize.
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example drop_in
//! ```
//!
//! `examples/patched/src/bin/step.rs` does the same in Rapier 0.36. Prints the number of pairs and contacts. Fails if a collider was
//! refused, or if no ball touches the floor or another ball.

use rapier3d::prelude::*;
use unisize::rapier3d_027::UnisizeBroadPhase;

fn main() {
    let mut bodies = RigidBodySet::new();
    let mut colliders = ColliderSet::new();
    colliders.insert(ColliderBuilder::cuboid(20.0, 0.5, 20.0));
    for i in 0..1000 {
        let (x, y, z) = (i % 10, i / 100, i / 10 % 10);
        let position = vector![x as f32 * 1.1, 1.5 + y as f32 * 1.1, z as f32 * 1.1];
        let body = bodies.insert(RigidBodyBuilder::dynamic().translation(position));
        colliders.insert_with_parent(ColliderBuilder::ball(0.5), body, &mut bodies);
    }

    // The only line that changes. It was `DefaultBroadPhase::new()`.
    let mut broad_phase = UnisizeBroadPhase::new();

    let mut pipeline = PhysicsPipeline::new();
    let mut islands = IslandManager::new();
    let mut narrow_phase = NarrowPhase::new();
    let mut impulse_joints = ImpulseJointSet::new();
    let mut multibody_joints = MultibodyJointSet::new();
    let mut ccd_solver = CCDSolver::new();
    for _ in 0..200 {
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

    let pairs = narrow_phase.contact_pairs();
    let contacts = pairs.filter(|pair| pair.has_any_active_contact).count();
    let stats = broad_phase.stats();
    println!(
        "{} colliders, {} pairs, {contacts} of them in contact",
        stats.proxies, stats.pairs
    );
    // unisize refuses a collider whose box is inverted or has a NaN, and logs the first one.
    assert_eq!(stats.refused, 0, "some colliders have no valid box");
    assert!(contacts > 0, "the balls do not touch anything");
}
