//! Has unisize the same pairs in your scene? `Trial` replaces the broad phase of your program for some hundred steps, and compares both.
//!
//! ```text
//! cargo run --release --bin trial
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
//! Rapier's own broad phase still drives the world, which moves as before, except that in large worlds pairs may come in another order.
//! unisize receives the same input at each filter level. Prints the report. Fails if unisize's pairs are not Rapier's.

use rapier3d::prelude::*;
use unisize::rapier3d_036::Trial;

fn main() {
    // Your scene instead.
    let mut world = PhysicsWorld::default();
    let floor = ColliderBuilder::cuboid(90.0, 1.0, 90.0).translation(Vector::new(0.0, -1.0, 0.0));
    world.colliders.insert(floor);
    for i in 0..3000 {
        let (x, y, z) = (i % 15, i / 225, i / 15 % 15);
        let position = Vector::new(x as f32, 1.0 + y as f32, z as f32) * 1.1;
        let body = RigidBodyBuilder::dynamic().translation(position);
        world.insert(body, ColliderBuilder::ball(0.5));
    }

    // The only line that changes.
    world.broad_phase = DefaultBroadPhase::custom(Trial::new());

    for _ in 0..300 {
        world.step();
    }

    let trial = world.broad_phase.custom_ref::<Trial>();
    let report = trial.expect("the trial is not active").report();
    println!("{report}");
    assert!(report.pairs_match(), "the pairs are not Rapier's own");
}
