//! Rapier 0.36 without its pipelines: beads with motions of their own. Parry finds out which of the pairs of `UnisizeBroadPhase`
//! touch, and these are reported as Rapier's `CollisionEvent`s.
//!
//! `cargo run --release --features rapier3d-036 --example collision_events`
//!
//! The beads fly about in a box, through each other; in its middle is a zone. With
//! `--verify` Rapier's own `CollisionPipeline` sees the same beads, and must report the same events in every step.

mod beads;
mod engine;
mod touching;

use anyhow::ensure;
use beads::Beads;
use clap::Parser;
use engine::Engine;
use rapier3d_036::prelude::*;
use touching::Touching;
use unisize::rapier3d_036::UnisizeBroadPhase;

#[derive(Parser)]
#[command(about = "Rapier 0.36's collision events without its pipelines")]
struct Options {
    /// How many beads there are.
    #[arg(long, default_value_t = 5000)]
    bodies: usize,
    /// How many steps of a sixtieth of a second are made.
    #[arg(long, default_value_t = 300)]
    steps: usize,
    /// Compare the events of each step with those of Rapier's own pipeline.
    #[arg(long)]
    verify: bool,
}

fn main() -> anyhow::Result<()> {
    let options = Options::parse();
    let params = IntegrationParameters::default();
    let mut beads = Beads::new(options.bodies);
    let mut broad_phase = UnisizeBroadPhase::new();
    let mut touching = Touching::default();
    let mut engine = options.verify.then(|| Engine::new(&beads));
    // No bodies: the colliders are all there is.
    let bodies = RigidBodySet::new();
    let mut changes = Vec::new();
    let [mut started, mut stopped] = [0; 2];
    for step in 0..options.steps {
        beads.fly(params.dt);
        // All of them have moved; none is ever removed.
        broad_phase.update(
            &params,
            &beads.colliders,
            &bodies,
            &beads.handles,
            &[],
            &mut changes,
        );
        let events = touching.renew(&mut changes, &beads.colliders);
        if let Some(engine) = &mut engine {
            let expected = engine.step(&beads, &params);
            ensure!(
                touching::sorted(&events) == touching::sorted(&expected),
                "step {step}: {events:?} instead of {expected:?}"
            );
        }
        started += events.iter().filter(|event| event.started()).count();
        stopped += events.iter().filter(|event| event.stopped()).count();
    }
    println!(
        "{} beads, {} steps: {started} contacts began and {stopped} ended; {} pairs at the end",
        options.bodies,
        options.steps,
        broad_phase.stats().pairs,
    );
    if engine.is_some() {
        println!("in every step the same events as those of Rapier's own pipeline");
    }
    Ok(())
}
