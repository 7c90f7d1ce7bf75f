//! bevy_rapier on unisize, without a window: thousands of balls fall into a box. Copy `plugin.rs`; README.md says how to build this.
//!
//! A second game with the same scene runs on `Trial`, which compares unisize's pairs with those of Rapier's own broad phase. Prints the report
//! of the trial. Fails if unisize is not active, if a pair differs, or if two balls overlap without a pair.

mod plugin;
mod scene;

use std::time::Duration;

use anyhow::{Result, anyhow, ensure};
use bevy::prelude::*;
use bevy::time::{TimePlugin, TimeUpdateStrategy};
use bevy_rapier3d::prelude::*;
use bevy_rapier3d::rapier::geometry::{ColliderHandle, DefaultBroadPhase};
use unisize::rapier3d_036::{Trial, UnisizeBroadPhase};

use plugin::UnisizePlugin;

const BALLS: u32 = 3000;
const STEPS: u32 = 300;

fn main() -> Result<()> {
    let mut game = game();
    game.add_plugins(UnisizePlugin);
    let mut trial = self::game();
    trial.add_observer(
        |added: On<Add<RapierContextSimulation>>,
         mut contexts: Query<&mut RapierContextSimulation>| {
            if let Ok(mut context) = contexts.get_mut(added.entity) {
                context.broad_phase = DefaultBroadPhase::custom(Trial::new());
            }
        },
    );
    // The first update spawns the scene.
    game.update();
    trial.update();
    for step in 1..STEPS {
        let overlapping = overlapping_balls(&mut game)?;
        game.update();
        trial.update();
        let narrow_phase = &simulation(&mut game)?.narrow_phase;
        for [ball1, ball2] in overlapping {
            let is_pair = narrow_phase.contact_pair(ball1, ball2).is_some();
            ensure!(is_pair, "step {step}: {ball1:?} and {ball2:?} overlap");
        }
    }

    let game = simulation(&mut game)?;
    let active = game.broad_phase.custom_ref::<UnisizeBroadPhase>();
    let stats = active
        .ok_or_else(|| anyhow!("unisize is not active"))?
        .stats();
    let pairs = game.narrow_phase.contact_pairs();
    let contacts = pairs.filter(|pair| pair.has_any_active_contact()).count();
    println!(
        "{BALLS} balls, {STEPS} steps: {} pairs, {contacts} contacts\n",
        stats.pairs
    );
    ensure!(contacts > 0, "nothing touches");

    let trial = simulation(&mut trial)?.broad_phase.custom_ref::<Trial>();
    let report = trial
        .ok_or_else(|| anyhow!("the trial is not active"))?
        .report();
    println!("{report}");
    ensure!(report.pairs_match(), "the pairs are not Rapier's own");
    Ok(())
}

/// A game without a window, which takes one fixed step per update.
fn game() -> App {
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
    app.add_systems(Startup, scene::spawn);
    app
}

fn simulation(app: &mut App) -> Result<&RapierContextSimulation> {
    let mut contexts = app.world_mut().query::<&RapierContextSimulation>();
    Ok(contexts.single(app.world())?)
}

/// Every two balls that overlap now, and so must be a pair in the next step. **O(n²)**.
fn overlapping_balls(app: &mut App) -> Result<Vec<[ColliderHandle; 2]>> {
    let mut contexts = app.world_mut().query::<&RapierContextColliders>();
    let colliders = &contexts.single(app.world())?.colliders;
    let balls = colliders.iter().filter_map(|(handle, collider)| {
        let radius = collider.shape().as_ball()?.radius;
        Some((handle, collider.translation(), radius))
    });
    let balls: Vec<_> = balls.collect();
    let mut overlapping = vec![];
    for (i, &(ball1, center1, radius1)) in balls.iter().enumerate() {
        for &(ball2, center2, radius2) in &balls[..i] {
            if (center1 - center2).length() < radius1 + radius2 {
                overlapping.push([ball1, ball2]);
            }
        }
    }
    Ok(overlapping)
}
