//! Updates of large worlds: one source, compiled once in each dimension.

#[path = "../update/frames.rs"]
mod frames;

use super::ours::UnisizeBroadPhase;
use super::rapier;
use super::rapier::prelude::*;
use super::version::{self, Driven};
use crate::{Cost, FRAMES, Motion, bytes_held};
use frames::{Frames, Parents};
use std::time::Duration;

/// That of the frames.
pub(crate) const DENSITY: f64 = frames::DENSITY;

/// What unisize takes, and what Rapier's own broad phase.
pub(crate) fn measure(count: usize) -> [Cost; 2] {
    [
        follow(count, UnisizeBroadPhase::new()),
        follow(count, DefaultBroadPhase::new()),
    ]
}

fn follow(count: usize, mut broad_phase: impl Driven) -> Cost {
    let mut frames = Frames::new(count, Motion::OneIn(1), Parents::Dynamic, &mut broad_phase);
    let times: Vec<_> = (0..FRAMES)
        .map(|_| {
            frames.advance();
            frames.update(&mut broad_phase)
        })
        .collect();
    Cost {
        mean: times.iter().sum::<Duration>() / FRAMES as u32,
        longest: times.into_iter().max().unwrap_or_default(),
        bytes: bytes_held(broad_phase),
    }
}
