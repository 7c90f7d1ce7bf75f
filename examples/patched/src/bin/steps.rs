//! What does your program gain? Run it on each broad phase, and read both tables side by side.
//!
//! ```text
//! cargo run --release --bin steps -- own
//! cargo run --release --bin steps -- unisize
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
//! Prints the mean, the median and the longest time of a step, while the bodies fall and once they have settled.

use std::ops::Range;
use std::time::{Duration, Instant};

use rapier3d::prelude::*;
use unisize::rapier3d_036::UnisizeBroadPhase;

/// The steps in which most bodies still fall, and those in which they have settled.
const WINDOWS: [(&str, Range<usize>); 2] = [("early", 0..120), ("settled", 600..720)];

fn main() {
    // Your scene instead.
    let mut world = PhysicsWorld::default();
    let floor = ColliderBuilder::cuboid(90.0, 1.0, 90.0).translation(Vector::new(0.0, -1.0, 0.0));
    world.colliders.insert(floor);
    for i in 0..3000 {
        let (x, y, z) = (i % 15, i / 225, i / 15 % 15);
        let position = Vector::new(x as f32, 1.0 + y as f32, z as f32) * 1.1;
        let body = RigidBodyBuilder::dynamic().translation(position);
        let shape = match i % 2 {
            0 => ColliderBuilder::ball(0.5),
            _ => ColliderBuilder::cuboid(0.5, 0.5, 0.5),
        };
        world.insert(body, shape);
    }

    let name = std::env::args().nth(1).unwrap_or_default();
    match name.as_str() {
        "own" => {}
        "unisize" => world.broad_phase = DefaultBroadPhase::custom(UnisizeBroadPhase::new()),
        _ => panic!("say `own` or `unisize`"),
    }
    let mut times = Vec::new();
    for _ in 0..WINDOWS[1].1.end {
        let began = Instant::now();
        world.step();
        times.push(began.elapsed());
    }

    println!("{name:12}  mean, ms  median, ms  longest, ms");
    for (window, steps) in WINDOWS {
        let times = &mut times[steps];
        times.sort_unstable();
        let mean = times.iter().sum::<Duration>() / times.len() as u32;
        let all = [mean, times[times.len() / 2], times[times.len() - 1]];
        let [mean, median, longest] = all.map(|time| time.as_secs_f64() * 1e3);
        println!("{window:12}{mean:10.3}{median:12.3}{longest:13.3}");
    }
}
