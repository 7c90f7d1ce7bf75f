//! Whole steps of the physics pipeline: 2,000 falling balls, with Rapier's own broad phase and with unisize.
//!
//! ```text
//! cargo bench --features rapier2d-027,rapier3d-027,parallel --bench step
//! ```
//!
//! Times the simulation from the start until most of the balls have landed: a pile costs more than balls in the
//! air, so single steps are not comparable. Throughput is in steps per second.
//!
//! The pipelines of Rapier 0.36 take unisize on an opened copy only: `opened/compare` measures whole steps there.

mod common;
#[path = "common/settings.rs"]
mod settings;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, SamplingMode, Throughput};
use std::time::{Duration, Instant};
use unisize_scenes::{SceneKind, dim2, dim3};

const BALLS: usize = 2_000;

/// Two simulated seconds.
const STEPS: usize = 120;

fn main() {
    let mut criterion = settings::criterion();
    for_each_dimension(&mut criterion);
    criterion.final_summary();
}

/// Times one broad phase in the dimension of a module of scenes.
macro_rules! simulation {
    ($group:expr, $name:literal, $dim:ident, $broad_phase:expr) => {
        simulation(&mut $group, $name, || {
            let mut scene = $dim::Scene::build(SceneKind::FallingBalls, BALLS, 7);
            let mut broad_phase = $broad_phase;
            move || scene.step(&mut broad_phase, &(), &())
        })
    };
}

fn for_each_dimension(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("step/2D");
    simulation!(
        group,
        "default",
        dim2,
        dim2::rapier::prelude::DefaultBroadPhase::new()
    );
    simulation!(
        group,
        "unisize",
        dim2,
        unisize::rapier2d_027::UnisizeBroadPhase::new()
    );
    group.finish();

    let mut group = criterion.benchmark_group("step/3D");
    simulation!(
        group,
        "default",
        dim3,
        dim3::rapier::prelude::DefaultBroadPhase::new()
    );
    simulation!(
        group,
        "unisize",
        dim3,
        unisize::rapier3d_027::UnisizeBroadPhase::new()
    );
    group.finish();
}

/// Times simulations. `build` makes a new world and returns the function that steps it.
fn simulation<S: FnMut()>(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    build: impl Fn() -> S,
) {
    let steps = if common::is_smoke_test() { 10 } else { STEPS };
    group.sampling_mode(SamplingMode::Flat);
    group.throughput(Throughput::Elements(steps as u64));
    group.bench_function(name, |bencher| {
        bencher.iter_custom(|iterations| {
            let mut elapsed = Duration::ZERO;
            for _ in 0..iterations {
                let mut step = build();
                let start = Instant::now();
                for _ in 0..steps {
                    step();
                }
                elapsed += start.elapsed();
            }
            elapsed
        });
    });
}
