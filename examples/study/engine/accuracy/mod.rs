//! Simulates and measures in one flavour of Rapier: one source, compiled once for each.

use super::{approximate, flavour, ours, scenes, space, version};

mod gauge;
mod stages;
#[cfg(test)]
mod tests;

use crate::accuracy::case::{Case, FRAMES, Reading, Run};
use crate::finder::{Finder, LOST_ONE_IN};
use approximate::Seldom;
use cpu_time::ThreadTime;
use scenes::rapier::prelude::*;
use scenes::{Lossy, Observed, OwnBroadPhase, Steppable, World, install};
use stages::Stage;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::time::Duration;

/// Simulates a case, and measures its errors.
pub(crate) fn run(case: &Case) -> Run {
    let stage = Stage::build(case);
    match case.finder {
        Finder::Rapier if case.is_sorted => {
            let sorted = Observed::new(OwnBroadPhase::new()).sorted();
            simulate(case, stage, &mut install(sorted))
        }
        Finder::Unisize(_) if case.is_sorted => {
            let settings = ours::Settings::default().with_filter(crate::FILTER_OF_DEFAULT);
            let ours = ours::UnisizeBroadPhase::with_settings(settings);
            let sorted = Observed::new(ours).sorted();
            simulate(case, stage, &mut install(sorted))
        }
        Finder::Rapier => simulate(case, stage, &mut DefaultBroadPhase::new()),
        Finder::Unisize(_) => simulate(case, stage, &mut install(ours::UnisizeBroadPhase::new())),
        Finder::Seldom(interval) => {
            let seldom = Seldom::new(ours::UnisizeBroadPhase::new(), interval);
            simulate(case, stage, &mut install(seldom))
        }
        Finder::Grid(cell) => {
            let mut grid = version::hash_grid(cell).expect("this version steps on grids");
            simulate(case, stage, &mut grid)
        }
        Finder::Lossy => {
            // Other pairs with each time step: otherwise a seed that loses none would lose none with any.
            let seed = case.seed << 32 | u64::from(case.frequency);
            let lossy = Lossy::new(OwnBroadPhase::new(), LOST_ONE_IN, seed);
            let mut control = install(lossy);
            let run = simulate(case, stage, &mut control);
            Run {
                pairs: Some([control.found, control.lost]),
                ..run
            }
        }
    }
}

/// Steps a stage to its end, and measures at the same simulated times whatever the time step.
fn simulate(case: &Case, mut stage: Stage, broad_phase: &mut impl Steppable) -> Run {
    stage.world.params.dt = 1.0 / case.frequency as Real;
    let frames = (case.seconds * f64::from(FRAMES)).round() as u32;
    let mut elapsed = Duration::ZERO;
    for frame in 1..=frames {
        let start = ThreadTime::now();
        for _ in 0..case.frequency / FRAMES {
            stage.world.step(broad_phase.for_step(), &(), &());
        }
        elapsed += start.elapsed();
        let time = f64::from(frame) / f64::from(FRAMES);
        for gauge in &mut stage.gauges {
            gauge.look(&stage.world, time);
        }
    }
    let readings = stage.gauges.iter().flat_map(|gauge| gauge.read());
    Run {
        milliseconds: elapsed.as_secs_f64() * 1e3 / case.seconds,
        errors: readings.map(Reading::or_infinite).collect(),
        pairs: None,
        state: state(&stage.world),
    }
}

/// A hash of the motions of all bodies, and of which of them sleep: it differs if any bit does, unless both are NaN.
fn state(world: &World) -> u64 {
    let mut hasher = DefaultHasher::new();
    for (_, body) in world.bodies.iter() {
        (space::motion(body), body.is_sleeping()).hash(&mut hasher);
    }
    hasher.finish()
}
