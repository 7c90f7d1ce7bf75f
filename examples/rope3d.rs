//! Ropes of jointed capsules fall over a bar and tangle, once on Rapier's own broad phase and once on unisize.
//!
//! ```text
//! cargo run --release --features rapier3d-027 --example rope3d
//! ```
//!
//! Prints how long a step takes on either. Fails if a joint comes apart or a rope falls through the floor.

use std::time::{Duration, Instant};

use rapier3d::prelude::*;
use unisize::rapier3d_027::UnisizeBroadPhase;

const ROPES: usize = 60;
const SEGMENTS: usize = 40;
/// Half the distance between the two joints of a segment.
const HALF: f32 = 0.25;
const STEPS: usize = 300;

struct Ropes {
    pipeline: PhysicsPipeline,
    islands: IslandManager,
    broad_phase: Box<dyn BroadPhase>,
    narrow_phase: NarrowPhase,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    impulse_joints: ImpulseJointSet,
    multibody_joints: MultibodyJointSet,
    ccd_solver: CCDSolver,
}

impl Ropes {
    fn new(broad_phase: Box<dyn BroadPhase>) -> Self {
        let mut world = Self {
            pipeline: PhysicsPipeline::new(),
            islands: IslandManager::new(),
            broad_phase,
            narrow_phase: NarrowPhase::new(),
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            impulse_joints: ImpulseJointSet::new(),
            multibody_joints: MultibodyJointSet::new(),
            ccd_solver: CCDSolver::new(),
        };
        let floor = ColliderBuilder::cuboid(30.0, 1.0, 30.0).translation(vector![0.0, -1.0, 0.0]);
        world.colliders.insert(floor);
        let bar = ColliderBuilder::capsule_z(20.0, 0.3).translation(vector![0.0, 5.0, 0.0]);
        world.colliders.insert(bar);
        for rope in 0..ROPES {
            let (layer, place) = (rope / 20, rope % 20);
            let start = vector![
                -HALF * SEGMENTS as f32 + 0.3 * layer as f32,
                6.0 + 0.5 * layer as f32,
                place as f32 - 10.0
            ];
            world.add_rope(start);
        }
        world
    }

    /// A rope along the first axis.
    fn add_rope(&mut self, start: Vector<f32>) {
        let mut previous = None;
        for segment in 0..SEGMENTS {
            let center = start + vector![HALF * (2 * segment + 1) as f32, 0.0, 0.0];
            let body = RigidBodyBuilder::dynamic().translation(center);
            let body = self.bodies.insert(body);
            let capsule = ColliderBuilder::capsule_x(HALF, 0.1);
            self.colliders
                .insert_with_parent(capsule, body, &mut self.bodies);
            if let Some(previous) = previous {
                let joint = SphericalJointBuilder::new()
                    .local_anchor1(point![HALF, 0.0, 0.0])
                    .local_anchor2(point![-HALF, 0.0, 0.0])
                    .contacts_enabled(false);
                self.impulse_joints.insert(previous, body, joint, true);
            }
            previous = Some(body);
        }
    }

    fn step(&mut self) {
        self.pipeline.step(
            &vector![0.0, -9.81, 0.0],
            &IntegrationParameters::default(),
            &mut self.islands,
            &mut *self.broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &mut self.impulse_joints,
            &mut self.multibody_joints,
            &mut self.ccd_solver,
            &(),
            &(),
        );
    }

    /// How far the two ends that the worst joint holds together are apart.
    fn longest_gap(&self) -> f32 {
        let gaps = self.impulse_joints.iter().map(|(_, joint)| {
            let [one, other] = [joint.body1, joint.body2].map(|body| self.bodies[body].position());
            let anchors = [joint.data.local_anchor1(), joint.data.local_anchor2()];
            (one * anchors[0] - other * anchors[1]).norm()
        });
        gaps.fold(0.0, f32::max)
    }

    fn lowest(&self) -> f32 {
        let heights = self.bodies.iter().map(|(_, body)| body.translation().y);
        heights.fold(f32::INFINITY, f32::min)
    }
}

fn main() {
    let mut worlds = [
        (
            "Rapier's own",
            Ropes::new(Box::new(DefaultBroadPhase::new())),
        ),
        ("unisize", Ropes::new(Box::new(UnisizeBroadPhase::new()))),
    ];
    let mut times = [Duration::ZERO; 2];
    // In turns, so that whatever else the machine does slows down both alike.
    for _ in 0..STEPS {
        for ((_, world), time) in worlds.iter_mut().zip(&mut times) {
            let start = Instant::now();
            world.step();
            *time += start.elapsed();
        }
    }
    for ((name, world), time) in worlds.iter().zip(times) {
        let (gap, lowest) = (world.longest_gap(), world.lowest());
        let ms = time.as_secs_f64() * 1e3 / STEPS as f64;
        println!("{name:>12}: {ms:.3} ms per step; longest gap at a joint {gap:.3}");
        assert!(gap < HALF, "a joint has come apart");
        assert!(lowest > -0.2, "a rope has fallen through the floor");
    }
}
