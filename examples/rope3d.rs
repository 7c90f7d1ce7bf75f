//! Ropes: capsules joined by spherical joints fall over a bar and tangle, once on Rapier's own broad phase and once on unisize.
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example rope3d
//! ```
//!
//! This is Rapier 0.27; `examples/patched/src/bin/rope.rs` does the same in 0.36. Prints the time of a step on either broad phase. Fails if
//! a joint comes apart or a rope falls through the floor.

use std::time::Instant;

use rapier3d::prelude::*;
use unisize::rapier3d_027::UnisizeBroadPhase;

const ROPES: usize = 60;
const SEGMENTS: usize = 40;
/// Half the distance between the two joints of a segment.
const HALF: f32 = 0.25;
const STEPS: usize = 300;

fn main() {
    run("Rapier's own", &mut DefaultBroadPhase::new());
    run("unisize", &mut UnisizeBroadPhase::new());
}

fn run(name: &str, broad_phase: &mut dyn BroadPhase) {
    let mut bodies = RigidBodySet::new();
    let mut colliders = ColliderSet::new();
    let mut joints = ImpulseJointSet::new();
    let floor = ColliderBuilder::cuboid(30.0, 1.0, 30.0).translation(vector![0.0, -1.0, 0.0]);
    colliders.insert(floor);
    let bar = ColliderBuilder::capsule_z(20.0, 0.3).translation(vector![0.0, 5.0, 0.0]);
    colliders.insert(bar);
    // Three layers of twenty ropes, which lie along the x axis.
    for rope in 0..ROPES {
        let (layer, place) = ((rope / 20) as f32, (rope % 20) as f32);
        let x = -HALF * SEGMENTS as f32 + 0.3 * layer;
        let start = vector![x, 6.0 + 0.5 * layer, place - 10.0];
        let mut previous = None;
        for segment in 0..SEGMENTS {
            let center = start + vector![HALF * (2 * segment + 1) as f32, 0.0, 0.0];
            let body = bodies.insert(RigidBodyBuilder::dynamic().translation(center));
            let capsule = ColliderBuilder::capsule_x(HALF, 0.1);
            colliders.insert_with_parent(capsule, body, &mut bodies);
            if let Some(previous) = previous {
                let joint = SphericalJointBuilder::new()
                    .local_anchor1(point![HALF, 0.0, 0.0])
                    .local_anchor2(point![-HALF, 0.0, 0.0])
                    .contacts_enabled(false);
                joints.insert(previous, body, joint, true);
            }
            previous = Some(body);
        }
    }

    let mut pipeline = PhysicsPipeline::new();
    let mut islands = IslandManager::new();
    let mut narrow_phase = NarrowPhase::new();
    let mut multibody_joints = MultibodyJointSet::new();
    let mut ccd_solver = CCDSolver::new();
    let start = Instant::now();
    for _ in 0..STEPS {
        pipeline.step(
            &vector![0.0, -9.81, 0.0],
            &IntegrationParameters::default(),
            &mut islands,
            broad_phase,
            &mut narrow_phase,
            &mut bodies,
            &mut colliders,
            &mut joints,
            &mut multibody_joints,
            &mut ccd_solver,
            &(),
            &(),
        );
    }
    let ms = start.elapsed().as_secs_f64() * 1e3 / STEPS as f64;

    // The distance between the two anchors of each joint.
    let gaps = joints.iter().map(|(_, joint)| {
        let [body1, body2] = [joint.body1, joint.body2].map(|body| bodies[body].position());
        let (anchor1, anchor2) = (joint.data.local_anchor1(), joint.data.local_anchor2());
        (body1 * anchor1 - body2 * anchor2).norm()
    });
    let gap = gaps.fold(0.0, f32::max);
    let heights = bodies.iter().map(|(_, body)| body.translation().y);
    let lowest = heights.fold(f32::INFINITY, f32::min);
    println!("{name:>12}: {ms:.3} ms per step; the widest gap at a joint is {gap:.3}");
    assert!(gap < HALF, "a joint has come apart");
    assert!(lowest > -0.2, "a rope has fallen through the floor");
}
