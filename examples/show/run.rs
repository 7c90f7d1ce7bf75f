//! The main loop of the small examples: a scene on unisize, which hands each update to Rapier's own broad phase as well.

use super::UnisizeBroadPhase;
use super::options::Options;
use super::scenes::rapier::prelude::*;
use super::scenes::{Observed, Scene, Tee};
use clap::Parser;
use std::process::ExitCode;
use unisize_scenes::SceneKind;

/// Simulates, and prints how long both broad phases take. Fails if their pairs ever differ, where that is to be verified.
pub(crate) fn run(kind: SceneKind) -> ExitCode {
    let options = Options::parse();
    let bodies = options.bodies.unwrap_or(kind.default_bodies());
    let mut scene = Scene::build(kind, bodies, 1);
    let unisize = Observed::new(UnisizeBroadPhase::new())
        .clocked()
        .with_held();
    let rapier = Observed::new(DefaultBroadPhase::new())
        .clocked()
        .with_held();
    let mut both = Tee::new(unisize, rapier);
    for step in 1..=options.steps {
        scene.step(&mut both, &(), &());
        if options.verify_pairs && both.heard.held() != both.unheard.held() {
            eprintln!("step {step}: the pairs differ");
            return ExitCode::FAILURE;
        }
    }
    let ms = [both.heard.timing(), both.unheard.timing()]
        .map(|timing| timing.total.as_secs_f64() * 1e3 / options.steps.max(1) as f64);
    println!(
        "{}: {} bodies, {} pairs after {} steps; milliseconds a step in the broad phase: unisize {:.3}, Rapier's own {:.3}",
        kind.name(),
        scene.world.bodies.len(),
        both.heard.held().len(),
        options.steps,
        ms[0],
        ms[1],
    );
    ExitCode::SUCCESS
}
