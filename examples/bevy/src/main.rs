//! bevy_rapier without a window: thousands of balls fall into a box, first with unisize tried beside Rapier's own broad phase, then on
//! unisize.

mod plugin;
mod scene;

use std::time::{Duration, Instant};

use anyhow::{Context, Result, ensure};
use bevy::prelude::{App, Commands, Startup, TransformPlugin};
use bevy::time::{TimePlugin, TimeUpdateStrategy};
use bevy_rapier3d::prelude::*;
use bevy_rapier3d::rapier::geometry::DefaultBroadPhase;
use clap::Parser;
use unisize::rapier3d_036::{Trial, UnisizeBroadPhase};

use plugin::BroadPhasePlugin;

/// Tries unisize in bevy_rapier, then uses it.
#[derive(Parser)]
struct Options {
    /// The number of balls
    #[arg(long, default_value_t = 3000)]
    balls: u32,

    /// The number of fixed steps, 60 a second
    #[arg(long, default_value_t = 300)]
    steps: u32,
}

fn main() -> Result<()> {
    let options = Options::parse();

    let mut tried = app(options.balls);
    tried.add_plugins(BroadPhasePlugin(|| {
        DefaultBroadPhase::custom(Trial::new())
    }));
    play(&mut tried, options.steps);
    let broad_phase = broad_phase(&mut tried)?;
    let trial: &Trial = broad_phase.custom_ref().context("no trial")?;
    let report = trial.report();
    println!("{report}");
    ensure!(report.is_equal(), "the pairs are different");
    ensure!(report.own.pairs > 0.0, "nothing has been near anything");

    let [mut own, mut ours] = [(); 2].map(|()| app(options.balls));
    ours.add_plugins(BroadPhasePlugin(|| {
        DefaultBroadPhase::custom(UnisizeBroadPhase::new())
    }));
    for (name, game) in [("Rapier's own", &mut own), ("unisize", &mut ours)] {
        let elapsed = play(game, options.steps).as_secs_f64();
        let per_update = 1e3 * elapsed / f64::from(options.steps.max(1));
        println!("{name}: {per_update:.3} ms an update of the game");
    }
    let broad_phase = self::broad_phase(&mut ours)?;
    let unisize: Option<&UnisizeBroadPhase> = broad_phase.custom_ref();
    ensure!(unisize.is_some(), "the game is not on unisize");
    Ok(())
}

/// A game without a window, which takes one fixed step an update.
fn app(balls: u32) -> App {
    let mut app = App::new();
    app.add_plugins((
        TransformPlugin,
        TimePlugin,
        RapierPhysicsPlugin::<NoUserData>::default(),
    ));
    let step = Duration::from_secs(1) / 60;
    app.insert_resource(TimeUpdateStrategy::ManualDuration(step));
    app.insert_resource(TimestepMode::Fixed {
        dt: step.as_secs_f32(),
        substeps: 1,
    });
    app.add_systems(Startup, move |commands: Commands| {
        scene::spawn(commands, balls)
    });
    app
}

/// Takes so many steps, and tells how long they took.
fn play(game: &mut App, steps: u32) -> Duration {
    let began = Instant::now();
    for _ in 0..steps {
        game.update();
    }
    began.elapsed()
}

fn broad_phase(app: &mut App) -> Result<&DefaultBroadPhase> {
    let mut contexts = app.world_mut().query::<&RapierContextSimulation>();
    Ok(&contexts.single(app.world())?.broad_phase)
}
