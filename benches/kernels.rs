//! The kernels alone: all overlapping pairs among boxes of one size, at several numbers and densities.
//!
//! ```text
//! cargo bench --bench kernels -- GridSweep
//! ```
//!
//! The paper's reference algorithms are measured as well.
//!
//! Between runs the boxes drift, as they would between two frames; that is not timed.
//! Throughput is in boxes a second.

mod common;
#[path = "common/settings.rs"]
mod settings;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput};
use std::hint::black_box;
use std::time::{Duration, Instant};
use unisize::{Aabb, GridSweep, PairFinder, RankSweep, Real};
use unisize_reference::{CoherentSweepAndPrune, DualAxisSweep, SweepAndPrune};
use unisize_scenes::DriftingBoxes;

/// Numbers of boxes.
const COUNTS: [usize; 4] = [1 << 10, 1 << 14, 1 << 17, 1 << 20];

/// The number of boxes for `f64`.
const F64_COUNT: usize = 1 << 17;

/// In 3D, most candidates of the paper's kernel and of its reference algorithms fail; beyond this, they take seconds.
const SWEEPS_3D_MAX: usize = 1 << 17;

/// The largest number of boxes in a smoke test.
const SMOKE_TEST_MAX: usize = 1 << 17;

fn main() {
    let mut criterion = settings::criterion();
    for density in [0.2, 0.8] {
        in_dimension::<2>(&mut criterion, density, usize::MAX);
    }
    for density in [0.1, 0.4] {
        in_dimension::<3>(&mut criterion, density, SWEEPS_3D_MAX);
    }
    criterion.final_summary();
}

/// Every kernel with every scalar and number of boxes.
fn in_dimension<const D: usize>(criterion: &mut Criterion, density: f64, sweeps_max: usize) {
    let mut group = criterion.benchmark_group(format!("kernels/{D}D/f32/density-{density}"));
    for count in COUNTS {
        if common::is_smoke_test() && count > SMOKE_TEST_MAX {
            continue;
        }
        kernel::<GridSweep<f32, D>, _, D>(&mut group, "GridSweep", count, density);
        if count <= sweeps_max {
            kernel::<RankSweep<f32, D>, _, D>(&mut group, "RankSweep", count, density);
            references::<f32, D>(&mut group, count, density);
        }
    }
    group.finish();

    let mut group = criterion.benchmark_group(format!("kernels/{D}D/f64/density-{density}"));
    kernel::<GridSweep<f64, D>, _, D>(&mut group, "GridSweep", F64_COUNT, density);
    kernel::<RankSweep<f64, D>, _, D>(&mut group, "RankSweep", F64_COUNT, density);
    references::<f64, D>(&mut group, F64_COUNT, density);
    group.finish();
}

/// The paper's reference algorithms on one input.
fn references<R: Real, const D: usize>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    count: usize,
    density: f64,
) {
    kernel::<SweepAndPrune<R, D>, _, D>(group, "SweepAndPrune", count, density);
    kernel::<CoherentSweepAndPrune<R, D>, _, D>(group, "CoherentSweepAndPrune", count, density);
    kernel::<DualAxisSweep<R, D>, _, D>(group, "DualAxisSweep", count, density);
}

/// One kernel on one input.
fn kernel<K: PairFinder<R, D> + Default, R: Real, const D: usize>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    count: usize,
    density: f64,
) {
    // Built only if it is not filtered out.
    let mut state = None;
    group.throughput(Throughput::Elements(count as u64));
    group.bench_function(BenchmarkId::new(name, count), |bencher| {
        let (drifting, finder) =
            state.get_or_insert_with(|| (DriftingBoxes::new(count, density, 7), K::default()));
        let (mut boxes, mut pairs) = (Vec::new(), Vec::new());
        bencher.iter_custom(|iterations| {
            let mut elapsed = Duration::ZERO;
            for _ in 0..iterations {
                drifting.advance();
                boxes.clear();
                boxes.extend(drifting.mins().iter().map(unit_box::<R, D>));
                let start = Instant::now();
                let found = finder.find_pairs(black_box(&boxes), &mut pairs);
                elapsed += start.elapsed();
                assert_eq!(found, Ok(()));
                black_box(&pairs);
            }
            elapsed
        });
    });
}

/// The unit box at a lower corner.
fn unit_box<R: Real, const D: usize>(mins: &[f32; D]) -> Aabb<R, D> {
    let mins = mins.map(|x| R::from_f64(f64::from(x)));
    let size = R::from_f64(f64::from(DriftingBoxes::<D>::SIZE));
    Aabb::new(mins, mins.map(|x| x + size))
}
