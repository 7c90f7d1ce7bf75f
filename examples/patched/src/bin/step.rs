//! Rapier 0.36 without `PhysicsWorld`: the program keeps all sets itself, and passes them to `PhysicsPipeline::step`. One line differs from
//! a program without unisize.
//!
//! ```text
//! cargo run --release --bin step
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
//! Prints the number of pairs and contacts. Fails if a collider was refused, if a ball falls through the floor, or if one ball is half
//! inside another.

use rapier3d::prelude::*;
use unisize::rapier3d_036::UnisizeBroadPhase;

const BALLS: usize = 1000;
const RADIUS: f32 = 0.5;

fn main() {
    let mut bodies = RigidBodySet::new();
    let mut colliders = ColliderSet::new();
    let floor = ColliderBuilder::cuboid(90.0, 1.0, 90.0).translation(Vector::new(0.0, -1.0, 0.0));
    colliders.insert(floor);
    for i in 0..BALLS {
        let (x, y, z) = (i % 10, i / 100, i / 10 % 10);
        let shift = 0.05 * (y % 3) as f32;
        let position = Vector::new(x as f32 + shift, 1.0 + y as f32, z as f32) * 1.1;
        let body = bodies.insert(RigidBodyBuilder::dynamic().translation(position));
        colliders.insert_with_parent(ColliderBuilder::ball(RADIUS), body, &mut bodies);
    }

    // The only line that changes. It was `DefaultBroadPhase::new()`.
    let mut broad_phase = DefaultBroadPhase::custom(UnisizeBroadPhase::new());

    let gravity = Vector::new(0.0, -9.81, 0.0);
    let params = IntegrationParameters::default();
    let mut pipeline = PhysicsPipeline::new();
    let mut islands = IslandManager::new();
    let mut narrow_phase = NarrowPhase::new();
    let mut impulse_joints = ImpulseJointSet::new();
    let mut multibody_joints = MultibodyJointSet::new();
    let mut soft_bodies = SoftBodySet::new();
    let mut ccd_solver = CCDSolver::new();
    for _ in 0..200 {
        pipeline.step(
            gravity,
            &params,
            &mut islands,
            &mut broad_phase,
            &mut narrow_phase,
            &mut bodies,
            &mut colliders,
            &mut impulse_joints,
            &mut multibody_joints,
            &mut soft_bodies,
            &mut ccd_solver,
            &(),
            &(),
        );
    }

    // This is how a program sees that unisize is active.
    let active = broad_phase.custom_ref::<UnisizeBroadPhase>();
    let stats = active.expect("unisize is not active").stats();
    let pairs = narrow_phase.contact_pairs();
    let contacts = pairs.filter(|pair| pair.has_any_active_contact()).count();
    println!(
        "{} colliders, {} pairs, {contacts} of them in contact",
        stats.proxies, stats.pairs
    );
    // unisize refuses a collider whose box is inverted or has a NaN, and logs the first one.
    assert_eq!(stats.refused, 0, "some colliders have no valid box");
    assert_eq!(stats.proxies, BALLS + 1, "some colliders are missing");

    // Without their pairs, balls would fall through the floor and through each other.
    let centers: Vec<_> = bodies.iter().map(|(_, body)| body.translation()).collect();
    let mut nearest = f32::INFINITY;
    for (i, &center) in centers.iter().enumerate() {
        assert!(center.y > 0.0, "a ball is below the floor");
        let distances = centers[..i].iter().map(|&other| (center - other).length());
        nearest = distances.fold(nearest, f32::min);
    }
    println!("the centers of two balls are at least {nearest:.3} apart");
    assert!(nearest > RADIUS, "a ball is inside another");
}
