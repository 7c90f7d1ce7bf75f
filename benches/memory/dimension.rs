//! The memory of broad phases: one source, compiled once in each dimension.

#[path = "../update/frames.rs"]
mod frames;

use super::ours::UnisizeBroadPhase;
use super::rapier;
use super::rapier::prelude::*;
use super::version::{self, Driven};
use crate::{Motion, bytes_held, common};
use frames::{Frames, Parents};

const COUNT: usize = 1 << 16;

/// The number of colliders in a smoke test.
const SMALL_COUNT: usize = 1_000;

const FRAMES: usize = 60;

/// The aim, in bytes per proxy and per pair.
const AIM: [f64; 2] = [96.0, 24.0];

/// Prints the line of one motion.
pub(crate) fn print(motion: Motion) {
    let count = if common::is_smoke_test() {
        SMALL_COUNT
    } else {
        COUNT
    };
    let mut ours = UnisizeBroadPhase::new();
    follow(motion, count, &mut ours);
    let pairs = ours.stats().pairs;
    let mut default = DefaultBroadPhase::new();
    follow(motion, count, &mut default);
    let per_collider = |bytes: f64| bytes / count as f64;
    println!(
        "| {} | {DIM}D | {} | {count} | {pairs} | {:.0} | {:.0} | {:.0} |",
        version::DEFAULT,
        motion.name(),
        per_collider(bytes_held(default) as f64),
        per_collider(bytes_held(ours) as f64),
        AIM[0] + AIM[1] * per_collider(pairs as f64),
    );
}

fn follow(motion: Motion, count: usize, broad_phase: &mut dyn Driven) {
    let mut frames = Frames::new(count, motion, Parents::None, broad_phase);
    for _ in 0..FRAMES {
        frames.advance();
        frames.update(broad_phase);
    }
}
