//! What a broad phase takes to follow moving colliders: one source, compiled once for each engine and dimension.

use super::engine::{self, Driven};
use super::frames::Frames;
use super::ours::UnisizeBroadPhase;
use super::rapier::math::DIM;
use super::rapier::prelude::DefaultBroadPhase;
use crate::bytes_held;
use crate::worlds::Case;
use serde_json::Value;
use std::time::Duration;

/// Frames before those that count: the first ones insert, and trees go on being mended for some more.
const FRAMES_TO_SETTLE: usize = 20;

/// The times, in ns a collider, and the bytes a collider of unisize and of Rapier's own, in this many frames.
pub(crate) fn measure(case: &Case, frames: usize) -> Vec<(&'static str, Value)> {
    let mut pairs = 0;
    let ours = UnisizeBroadPhase::new();
    let ours = follow(case, frames, ours, |ours| pairs = ours.stats().pairs);
    let default = follow(case, frames, DefaultBroadPhase::new(), |_| {});
    vec![
        ("rapier", engine::RAPIER.into()),
        ("dim", DIM.into()),
        ("motion", case.motion.name().into()),
        ("bodies", case.bodies.into()),
        ("count", case.count.into()),
        ("pairs", pairs.into()),
        ("default_ns", default[0].into()),
        ("default_longest_ns", default[1].into()),
        ("default_bytes", default[2].into()),
        ("ours_ns", ours[0].into()),
        ("ours_longest_ns", ours[1].into()),
        ("ours_bytes", ours[2].into()),
    ]
}

/// The mean time, the longest and the bytes, each by collider.
fn follow<B: Driven>(
    case: &Case,
    count: usize,
    mut broad_phase: B,
    mut after: impl FnMut(&B),
) -> [f64; 3] {
    let mut frames = Frames::new(case, &mut broad_phase);
    for _ in 0..FRAMES_TO_SETTLE {
        frames.advance(&mut broad_phase);
    }
    let frame = |_| {
        let time = frames.advance(&mut broad_phase);
        after(&broad_phase);
        time
    };
    let times: Vec<_> = (0..count).map(frame).collect();
    let mean = times.iter().sum::<Duration>() / count as u32;
    let longest = times.into_iter().max().unwrap_or_default();
    let bytes = bytes_held(broad_phase) as f64 / case.count as f64;
    [
        ns_each(mean, case.count),
        ns_each(longest, case.count),
        bytes,
    ]
}

/// Nanoseconds for each of so many.
fn ns_each(time: Duration, count: usize) -> f64 {
    time.as_secs_f64() * 1e9 / count as f64
}
