//! A crowd in Rapier 0.36: walkers steer to their goals on a plaza, and push each other aside, on Rapier's own broad phase and on unisize.
//!
//! ```text
//! cargo run --release --bin crowd
//! ```
//!
//! README.md says how to make the patched copy of Rapier first. A `Cargo.toml` of yours needs these lines below `[dependencies]`, with the
//! path to your clone of unisize:
//!
//! ```toml
//! oorandom = "11"
//! rapier3d = "=0.36.1"
//! unisize = { path = "../unisize", features = ["rapier3d-036"] }
//! ```
//!
//! The program sets the velocity of each walker before each step; `examples/crowd2d.rs` moves a crowd without a pipeline. Prints the time
//! of a step on either broad phase. Fails if a walker sinks into the ground, or if Parry finds two walkers that touch and are not a pair
//! of the narrow phase.

use std::time::{Duration, Instant};

use oorandom::Rand32;
use rapier3d::parry::query::intersection_test;
use rapier3d::prelude::*;
use unisize::rapier3d_036::UnisizeBroadPhase;

/// The walkers start in this many rows of this many.
const SIDE: usize = 39;
/// Half the width of the plaza.
const HALF: f32 = 20.0;
const SPEED: f32 = 1.4;
const STEPS: usize = 600;

/// The walkers are the only bodies.
fn plaza() -> PhysicsWorld {
    let mut world = PhysicsWorld::default();
    let ground = ColliderBuilder::cuboid(2.0 * HALF, 1.0, 2.0 * HALF);
    let ground = ground.translation(Vector::new(0.0, -1.0, 0.0));
    world.colliders.insert(ground);
    for i in 0..SIDE * SIDE {
        let [x, z] = [i % SIDE, i / SIDE].map(|place| 2.0 * HALF * place as f32 / SIDE as f32);
        let position = Vector::new(x - HALF, 0.9, z - HALF);
        let body = RigidBodyBuilder::dynamic().translation(position);
        let shape = ColliderBuilder::capsule_y(0.6, 0.3).friction(0.0);
        // A walker does not fall over.
        world.insert(body.lock_rotations(), shape);
    }
    world
}

fn anywhere(random: &mut Rand32) -> Vector {
    let mut coordinate = || HALF * (2.0 * random.rand_float() - 1.0);
    Vector::new(coordinate(), 0.0, coordinate())
}

fn steer(world: &mut PhysicsWorld, goals: &mut [Vector], random: &mut Rand32) {
    for ((_, walker), goal) in world.bodies.iter_mut().zip(goals) {
        let mut to_goal = *goal - walker.translation();
        to_goal.y = 0.0;
        if to_goal.length() < 1.0 {
            *goal = anywhere(random);
        }
        let mut velocity = to_goal.normalize_or_zero() * SPEED;
        velocity.y = walker.linvel().y;
        walker.set_linvel(velocity, true);
    }
}

fn main() {
    let mut unisize = plaza();
    // The only line that changes.
    unisize.broad_phase = DefaultBroadPhase::custom(UnisizeBroadPhase::new());

    let mut worlds = [("Rapier's own", plaza()), ("unisize", unisize)];
    let mut random = Rand32::new(1);
    let goals: Vec<_> = (0..SIDE * SIDE).map(|_| anywhere(&mut random)).collect();
    let mut goals = [goals.clone(), goals];
    let mut times = [Duration::ZERO; 2];
    // The worlds take turns, so that other load on the machine slows both down alike.
    for _ in 0..STEPS {
        for (((_, world), goals), time) in worlds.iter_mut().zip(&mut goals).zip(&mut times) {
            steer(world, goals, &mut random);
            let start = Instant::now();
            world.step();
            *time += start.elapsed();
        }
    }

    for ((name, world), time) in worlds.iter_mut().zip(times) {
        // Brings the pairs up to date with the last step, which has moved the walkers.
        world.detect_collisions(&(), &());
        let walkers = world.colliders.iter();
        let walkers: Vec<_> = walkers.filter(|(_, it)| it.parent().is_some()).collect();
        let mut touching = 0;
        for (i, (handle1, a)) in walkers.iter().enumerate() {
            assert!(a.translation().y > 0.4, "a walker has sunk into the ground");
            for (handle2, b) in &walkers[..i] {
                let test = intersection_test(a.position(), a.shape(), b.position(), b.shape());
                if test.is_ok_and(|test| test.intersecting) {
                    let pair = world.contact_pair(*handle1, *handle2);
                    assert!(pair.is_some(), "a pair is missing");
                    touching += 1;
                }
            }
        }
        let ms = time.as_secs_f64() * 1e3 / STEPS as f64;
        println!("{name:>12}: {ms:.2} ms per step; {touching} pairs of walkers touch");
        assert!(touching > 0, "no walker touches another");
    }
}
