//! Rollback: a program steps ahead of its network, and goes back when it was wrong. There are two ways to put a world back.
//!
//! ```text
//! cargo run --release --bin rollback
//! ```
//!
//! README.md says how to make the patched copy of Rapier first. A `Cargo.toml` of yours needs these lines below `[dependencies]`, with the
//! path to your clone of unisize:
//!
//! ```toml
//! rapier3d = "=0.36.1"
//! stats_alloc = "0.1"
//! unisize = { path = "../unisize", features = ["rapier3d-036"] }
//! ```
//!
//! Prints what each way costs for 10,000 bodies, on Rapier's own broad phase and on unisize. Fails if the world does not go on as before.

use std::alloc::System;
use std::time::Instant;

use rapier3d::prelude::*;
use stats_alloc::{INSTRUMENTED_SYSTEM, Region, StatsAlloc};
use unisize::rapier3d_036::UnisizeBroadPhase;

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

const BODIES: usize = 10_000;
/// Steps until a clone is made, and until it is put back.
const STEPS: [usize; 2] = [30, 3];

/// What decides how a world goes on.
#[derive(Clone)]
struct State {
    bodies: RigidBodySet,
    colliders: ColliderSet,
    islands: IslandManager,
    narrow_phase: NarrowPhase,
    impulse_joints: ImpulseJointSet,
    multibody_joints: MultibodyJointSet,
}

impl State {
    fn of(world: &PhysicsWorld) -> Self {
        Self {
            bodies: world.bodies.clone(),
            colliders: world.colliders.clone(),
            islands: world.islands.clone(),
            narrow_phase: world.narrow_phase.clone(),
            impulse_joints: world.impulse_joints.clone(),
            multibody_joints: world.multibody_joints.clone(),
        }
    }

    fn put_back(self, world: &mut PhysicsWorld) {
        world.bodies = self.bodies;
        world.colliders = self.colliders;
        world.islands = self.islands;
        world.narrow_phase = self.narrow_phase;
        world.impulse_joints = self.impulse_joints;
        world.multibody_joints = self.multibody_joints;
    }
}

fn world(broad_phase: DefaultBroadPhase) -> PhysicsWorld {
    let mut world = PhysicsWorld::default();
    world.broad_phase = broad_phase;
    let floor = ColliderBuilder::cuboid(90.0, 1.0, 90.0).translation(Vector::new(0.0, -1.0, 0.0));
    world.colliders.insert(floor);
    for i in 0..BODIES {
        let (x, y, z) = (i % 25, i / 625, i / 25 % 25);
        let shift = 0.05 * (y % 3) as f32;
        let position = Vector::new(x as f32 + shift, 1.0 + y as f32, z as f32) * 1.1;
        let body = RigidBodyBuilder::dynamic().translation(position);
        world.insert(body, ColliderBuilder::ball(0.5));
    }
    world
}

/// Makes some steps. Returns the microseconds of the first.
fn steps(world: &mut PhysicsWorld, count: usize) -> f64 {
    let start = Instant::now();
    world.step();
    let first = start.elapsed().as_secs_f64() * 1e6;
    (1..count).for_each(|_| world.step());
    first
}

fn positions(world: &PhysicsWorld) -> Vec<Vector> {
    world
        .bodies
        .iter()
        .map(|(_, body)| body.translation())
        .collect()
}

fn main() {
    let broad_phases = [
        ("Rapier's own", DefaultBroadPhase::new()),
        (
            "unisize",
            DefaultBroadPhase::custom(UnisizeBroadPhase::new()),
        ),
    ];
    for (name, broad_phase) in broad_phases {
        let mut world = world(broad_phase);
        steps(&mut world, STEPS[0]);
        let (start, region) = (Instant::now(), Region::new(ALLOCATOR));
        let broad_phase = world.broad_phase.clone();
        let (us, change) = (start.elapsed().as_secs_f64() * 1e6, region.change());
        let bytes = change.bytes_allocated - change.bytes_deallocated;
        println!("{name}: a clone of the broad phase takes {us:.0} us and {bytes} bytes");
        let state = State::of(&world);
        steps(&mut world, STEPS[1]);
        let expected = positions(&world);

        // The first way: everything, the broad phase too. The world goes on bit for bit.
        state.clone().put_back(&mut world);
        world.broad_phase = broad_phase;
        let us = steps(&mut world, STEPS[1]);
        println!("{name}: with the broad phase put back, a step takes {us:.0} us");
        assert!(positions(&world) == expected, "the world goes on otherwise");

        // The second way: the sets alone. The next step on unisize notices that they are others, and reads all colliders.
        state.put_back(&mut world);
        let us = steps(&mut world, 1);
        println!("{name}: with the sets alone put back, the next step takes {us:.0} us");
        steps(&mut world, 300);
        let heights = positions(&world).into_iter().map(|position| position.y);
        let lowest = heights.fold(f32::INFINITY, f32::min);
        assert!(lowest > 0.0, "a body is below the floor");
    }
}
