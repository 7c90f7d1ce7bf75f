//! Saving a world and going on from it, bit for bit, with unisize.
//!
//! ```text
//! cargo run --release --features rapier3d-027,serde-serialize --example save
//! ```
//!
//! This is Rapier 0.27: the broad phase is saved beside the sets. The guide says what is different in 0.36. Fails if the world that was
//! loaded moves differently from the one that was saved.

use rapier3d::prelude::*;
use serde::{Deserialize, Serialize};
use unisize::rapier3d_027::UnisizeBroadPhase;

#[derive(Serialize, Deserialize)]
struct World {
    islands: IslandManager,
    broad_phase: UnisizeBroadPhase,
    narrow_phase: NarrowPhase,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    impulse_joints: ImpulseJointSet,
    multibody_joints: MultibodyJointSet,
}

impl World {
    fn new() -> Self {
        let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
        colliders.insert(ColliderBuilder::cuboid(20.0, 0.5, 20.0));
        for i in 0..500 {
            let (x, y, z) = (i % 8, i / 64, i / 8 % 8);
            let place = vector![x as f32 * 1.1, 1.2 + y as f32 * 1.1, z as f32 * 1.1];
            let body =
                RigidBodyBuilder::dynamic().translation(place + vector![0.1, 0.0, 0.0] * y as f32);
            let body = bodies.insert(body);
            colliders.insert_with_parent(ColliderBuilder::cuboid(0.5, 0.5, 0.5), body, &mut bodies);
        }
        Self {
            islands: IslandManager::new(),
            broad_phase: UnisizeBroadPhase::new(),
            narrow_phase: NarrowPhase::new(),
            bodies,
            colliders,
            impulse_joints: ImpulseJointSet::new(),
            multibody_joints: MultibodyJointSet::new(),
        }
    }

    fn run(&mut self, steps: usize) {
        // These have nothing to save.
        let (mut pipeline, mut ccd_solver) = (PhysicsPipeline::new(), CCDSolver::new());
        for _ in 0..steps {
            pipeline.step(
                &vector![0.0, -9.81, 0.0],
                &IntegrationParameters::default(),
                &mut self.islands,
                &mut self.broad_phase,
                &mut self.narrow_phase,
                &mut self.bodies,
                &mut self.colliders,
                &mut self.impulse_joints,
                &mut self.multibody_joints,
                &mut ccd_solver,
                &(),
                &(),
            );
        }
    }

    fn poses(&self) -> Vec<Isometry<f32>> {
        self.bodies
            .iter()
            .map(|(_, body)| *body.position())
            .collect()
    }
}

fn main() {
    let mut world = World::new();
    world.run(100);
    let saved = postcard::to_stdvec(&world).expect("all parts can be serialized");
    let mut loaded: World = postcard::from_bytes(&saved).expect("it was written by this program");
    world.run(100);
    loaded.run(100);
    assert!(
        world.poses() == loaded.poses(),
        "the world that was loaded moves differently"
    );
    let broad_phase = postcard::to_stdvec(&world.broad_phase).expect("it can be serialized");
    println!(
        "saved {} kB, {} kB of them the broad phase; 100 steps later both worlds are equal to the bit",
        saved.len() / 1000,
        broad_phase.len() / 1000
    );
}
