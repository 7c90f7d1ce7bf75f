//! bevy_rapier without a window, on unisize: thousands of balls fall into a box, and in every step the pairs of the two broad
//! phases, and the contacts that the physics makes of them, are compared.

mod both;
mod plugin;
mod scene;

use std::collections::HashSet;
use std::time::Duration;

use anyhow::{Context, Result, bail, ensure};
use bevy::prelude::{App, Commands, Startup, TransformPlugin};
use bevy::time::{TimePlugin, TimeUpdateStrategy};
use bevy_rapier3d::prelude::*;
use bevy_rapier3d::rapier::geometry::{ColliderHandle, DefaultBroadPhase};
use clap::Parser;
use unisize::rapier3d_036::UnisizeBroadPhase;

use both::Both;
use plugin::UnisizePlugin;

/// Compares unisize with Rapier's own broad phase in bevy_rapier, step by step.
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
    let mut game = app(options.balls);
    game.add_plugins(UnisizePlugin);
    let mut compared = app(options.balls);
    compared.add_plugins(both::BothPlugin);

    let (mut most, [mut ours, mut default]) = (0, [0; 2]);
    for step in 0..options.steps {
        game.update();
        compared.update();
        // The same events in the same order make the same worlds, to the bit.
        let contacts = [contacts(&mut game)?, contacts(&mut compared)?];
        ensure!(
            contacts[0] == contacts[1],
            "step {step}: the contacts of the two worlds are different"
        );
        most = most.max(contacts[0].len());
        let broad_phase = broad_phase(&mut compared)?;
        let both = broad_phase
            .custom_ref::<Both>()
            .context("no broad phase of both")?;
        if let Some(fault) = both.fault() {
            bail!("step {step}: {fault}");
        }
        [ours, default] = both.counts();
    }

    broad_phase(&mut game)?
        .custom_ref::<UnisizeBroadPhase>()
        .context("the game is not on unisize")?;
    ensure!(most > 0, "nothing has touched");
    println!(
        "{} balls, {} steps: at the end unisize holds {ours} of Rapier's {default} pairs, and in no step did one of the others touch; \
         equal contacts in every step, up to {most}",
        options.balls, options.steps,
    );
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

fn broad_phase(app: &mut App) -> Result<&DefaultBroadPhase> {
    let mut contexts = app.world_mut().query::<&RapierContextSimulation>();
    Ok(&contexts.single(app.world())?.broad_phase)
}

/// The pairs of colliders that touch.
fn contacts(app: &mut App) -> Result<HashSet<[ColliderHandle; 2]>> {
    let mut contexts = app.world_mut().query::<&RapierContextSimulation>();
    let touching = contexts.single(app.world())?.narrow_phase.contact_pairs();
    let touching = touching.filter(|pair| pair.has_any_active_contact());
    Ok(touching
        .map(|pair| both::pair(pair.collider1, pair.collider2))
        .collect())
}
