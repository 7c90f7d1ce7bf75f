//! Saving a world and continuing from the save, bit for bit.
//!
//! ```text
//! cargo run --release --features rapier3d-027,serde-serialize --example save
//! ```
//!
//! This is Rapier 0.27: the broad phase is saved with the sets. `examples/patched/src/bin/save.rs` does the same in 0.36. Prints the size
//! of the save. Fails if the loaded world moves differently from the saved one.

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
        let mut bodies = RigidBodySet::new();
        let mut colliders = ColliderSet::new();
        colliders.insert(ColliderBuilder::cuboid(20.0, 0.5, 20.0));
        for i in 0..500 {
            // A leaning tower, so that it collapses.
            let (x, y, z) = ((i % 8) as f32, (i / 64) as f32, (i / 8 % 8) as f32);
            let position = vector![x * 1.1 + y * 0.1, 1.2 + y * 1.1, z * 1.1];
            let body = bodies.insert(RigidBodyBuilder::dynamic().translation(position));
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
        // These have no state to save.
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

    fn positions(&self) -> Vec<Isometry<f32>> {
        let bodies = self.bodies.iter();
        bodies.map(|(_, body)| *body.position()).collect()
    }
}

fn main() {
    let mut world = World::new();
    world.run(100);
    let saved = postcard::to_stdvec(&world).expect("a world can be serialized");
    let mut loaded: World = postcard::from_bytes(&saved).expect("the save is complete");
    world.run(100);
    loaded.run(100);
    assert!(
        world.positions() == loaded.positions(),
        "the loaded world moves differently"
    );
    let broad_phase =
        postcard::to_stdvec(&world.broad_phase).expect("a broad phase can be serialized");
    println!(
        "saved {} kB, {} kB of them the broad phase; 100 steps later both worlds are equal bit for bit",
        saved.len() / 1000,
        broad_phase.len() / 1000
    );
}
