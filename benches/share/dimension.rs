//! The steps: one source, compiled once in each dimension.

use super::ours::UnisizeBroadPhase;
use super::scenes::rapier::prelude::*;
use super::scenes::{Observed, Scene};
use crate::STEPS;
use std::time::{Duration, Instant};
use unisize_scenes::SceneKind;

/// Prints a line for each broad phase.
pub(crate) fn print(count: usize) {
    simulate("default", count, DefaultBroadPhase::new());
    simulate("unisize", count, UnisizeBroadPhase::new());
}

fn simulate<B: BroadPhase>(name: &str, count: usize, inner: B) {
    let mut scene = Scene::build(SceneKind::FallingBalls, count, 7);
    let mut clocked = Observed::new(inner).clocked();
    let start = Instant::now();
    for _ in 0..STEPS {
        scene.step(&mut clocked, &(), &());
    }
    let all = start.elapsed();
    let milliseconds = |time: Duration| time.as_secs_f64() * 1e3 / f64::from(STEPS);
    let (step, its) = (milliseconds(all), milliseconds(clocked.timing().total));
    println!(
        "| {DIM}D | {count} | {name} | {step:.2} | {its:.3} | {:.1} % |",
        100.0 * its / step
    );
}
