//! The smallest program: a pile of balls on a floor, on unisize in place of Rapier's own broad phase. Copy the one marked line.
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example drop_in
//! ```
//!
//! This is Rapier 0.27, whose pipeline takes any broad phase. For 0.36 see `examples/patched`.

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
    let touching = pairs.filter(|pair| pair.has_any_active_contact).count();
    let stats = broad_phase.stats();
    println!(
        "{} colliders, {} pairs, {touching} of them touch",
        stats.proxies, stats.pairs
    );
    // A collider whose box has a NaN or is inverted is refused, and the first one is logged.
    assert_eq!(stats.refused, 0, "some colliders have no valid box");
    assert!(touching > 0, "the balls lie on the floor");
}
