//! The updates: one source, compiled once in each dimension.

#[path = "frames.rs"]
mod frames;

use super::ours::UnisizeBroadPhase;
use super::rapier;
use super::rapier::prelude::*;
use super::version::{self, Driven};
use crate::{Motion, common};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput};
use frames::{Frames, Parents};
use std::time::Duration;

/// Numbers of colliders.
const COUNTS: [usize; 3] = [100, 10_000, 1 << 17];

/// The largest number of colliders in a smoke test.
const SMOKE_TEST_MAX: usize = 10_000;

/// Rapier's broad phase goes on optimizing its tree for some frames after the first.
const FRAMES_TO_SETTLE: usize = 5;

/// Every motion with every number of colliders and both broad phases.
pub(crate) fn bench(criterion: &mut Criterion) {
    for motion in Motion::ALL {
        let mut group = criterion.benchmark_group(format!(
            "update/{}/{DIM}D/{}",
            version::DEFAULT,
            motion.name()
        ));
        for count in COUNTS {
            let is_too_large = common::is_smoke_test() && count > SMOKE_TEST_MAX;
            // With fewer colliders than the stride, only one moves: the same case as a stride of their number.
            if !is_too_large && motion.stride() <= count {
                both(&mut group, count, motion);
            }
        }
        group.finish();
    }
}

fn both(group: &mut BenchmarkGroup<'_, WallTime>, count: usize, motion: Motion) {
    update(group, "default", DefaultBroadPhase::new, count, motion);
    update(group, "unisize", UnisizeBroadPhase::new, count, motion);
}

/// One broad phase in one case.
fn update<B: Driven>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    create: fn() -> B,
    count: usize,
    motion: Motion,
) {
    // Built only if it is not filtered out.
    let mut state = None;
    group.throughput(Throughput::Elements(count as u64));
    group.bench_function(BenchmarkId::new(name, count), |bencher| {
        let (frames, broad_phase) = state.get_or_insert_with(|| {
            let mut broad_phase = create();
            let mut frames = Frames::new(count, motion, Parents::None, &mut broad_phase);
            for _ in 0..FRAMES_TO_SETTLE {
                frames.advance();
                frames.update(&mut broad_phase);
            }
            (frames, broad_phase)
        });
        bencher.iter_custom(|iterations| {
            let mut elapsed = Duration::ZERO;
            for _ in 0..iterations {
                frames.advance();
                elapsed += frames.update(broad_phase);
            }
            elapsed
        });
    });
}
