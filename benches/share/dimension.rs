//! The steps: one source, compiled once in each dimension.

use super::ours::UnisizeBroadPhase;
use super::scenes::Scene;
use super::scenes::rapier::prelude::*;
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
    let mut clocked = Clocked {
        inner,
        elapsed: Duration::ZERO,
    };
    let start = Instant::now();
    for _ in 0..STEPS {
        scene.step(&mut clocked, &(), &());
    }
    let all = start.elapsed();
    let milliseconds = |time: Duration| time.as_secs_f64() * 1e3 / f64::from(STEPS);
    let (step, its) = (milliseconds(all), milliseconds(clocked.elapsed));
    println!(
        "| {DIM}D | {count} | {name} | {step:.2} | {its:.3} | {:.1} % |",
        100.0 * its / step
    );
}

/// A broad phase whose updates are timed.
struct Clocked<B> {
    inner: B,
    elapsed: Duration,
}

impl<B: BroadPhase> BroadPhase for Clocked<B> {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let start = Instant::now();
        let inner = &mut self.inner;
        inner.update(params, colliders, bodies, modified, removed, events);
        self.elapsed += start.elapsed();
    }
}
