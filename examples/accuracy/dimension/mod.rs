//! Simulates and measures in one flavour of Rapier: one source, compiled once for each.

use super::{PIN, ours, scenes, version};

mod gauges;
mod space;
mod stages;
#[cfg(test)]
mod tests;

use crate::case::{Case, FRAMES, Finder, LOST_ONE_IN, Reading, Run};
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
        Finder::Unisize if case.is_sorted => {
            let settings = ours::Settings::default().with_filter(crate::FILTER_OF_DEFAULT);
            let ours = ours::UnisizeBroadPhase::with_settings(settings);
            let sorted = Observed::new(ours).sorted();
            simulate(case, stage, &mut install(sorted))
        }
        Finder::Rapier => simulate(case, stage, &mut DefaultBroadPhase::new()),
        Finder::Unisize => simulate(case, stage, &mut install(ours::UnisizeBroadPhase::new())),
        Finder::Control => {
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

/// A hash of the poses and velocities of all bodies, and of which of them sleep.
///
/// Of the numbers as text, which has as many digits as tell a number from all others, and the sign of zero: it differs if any
/// bit does, unless both are NaN.
fn state(world: &World) -> u64 {
    let mut hasher = DefaultHasher::new();
    for (_, body) in world.bodies.iter() {
        let motion = (body.position(), body.linvel(), body.angvel());
        format!("{motion:?} {}", body.is_sleeping()).hash(&mut hasher);
    }
    hasher.finish()
}
