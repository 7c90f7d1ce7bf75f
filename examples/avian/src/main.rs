//! Two games without a window, each of thousands of balls in a box: Avian on its own broad phase and on unisize, in turns.

mod broad_phase;

use std::collections::BTreeSet;
use std::time::{Duration, Instant};

use anyhow::{Result, ensure};
use avian3d::collision::CollisionDiagnostics;
use avian3d::prelude::*;
use bevy::prelude::*;
use bevy::time::TimeUpdateStrategy;
use broad_phase::UnisizeBroadPhasePlugin;
use clap::Parser;

/// Times Avian on unisize beside Avian as it is.
#[derive(Parser)]
struct Options {
    /// The number of balls
    #[arg(long, default_value_t = 5000)]
    balls: u32,

    /// The number of steps, 60 a second
    #[arg(long, default_value_t = 300)]
    steps: u32,
}

/// A game, and what its steps have taken.
struct Game {
    app: App,
    steps: Duration,
    broad_phase: Duration,
}

fn main() -> Result<()> {
    let options = Options::parse();
    let mut games = [false, true].map(|on_unisize| Game::new(on_unisize, options.balls));
    let mut compared = 0;
    for step in 0..options.steps {
        for game in &mut games {
            game.step();
        }
        // The solver depends on the order of pairs, so after some collisions the two go their own ways.
        if compared == step && games[0].places() == games[1].places() {
            let [own, ours] = [0, 1].map(|i| games[i].pairs());
            ensure!(own == ours, "step {step}: the pairs are different");
            compared += 1;
        }
    }
    println!("equal pairs in the {compared} steps in which both games were equal to the bit");
    for (name, game) in [("Avian's own", &games[0]), ("unisize", &games[1])] {
        let [step, broad_phase] = [game.steps, game.broad_phase]
            .map(|time| 1e3 * time.as_secs_f64() / f64::from(options.steps.max(1)));
        println!("{name:12} {step:7.3} ms a step, {broad_phase:7.3} ms of it broad phase");
    }
    let ratio = games[0].steps.as_secs_f64() / games[1].steps.as_secs_f64();
    println!("whole steps are {ratio:.2} times as fast on unisize");
    Ok(())
}

impl Game {
    fn new(on_unisize: bool, balls: u32) -> Self {
        let mut app = App::new();
        app.add_plugins((MinimalPlugins, TransformPlugin));
        if on_unisize {
            let physics = PhysicsPlugins::default()
                .build()
                .disable::<BvhBroadPhasePlugin>();
            app.add_plugins(physics.add(UnisizeBroadPhasePlugin));
        } else {
            app.add_plugins(PhysicsPlugins::default());
        }
        let step = Duration::from_secs(1) / 60;
        app.insert_resource(TimeUpdateStrategy::ManualDuration(step));
        app.insert_resource(Time::<Fixed>::from_duration(step));
        app.add_systems(Startup, move |commands: Commands| spawn(commands, balls));
        app.finish();
        app.cleanup();
        Self {
            app,
            steps: Duration::ZERO,
            broad_phase: Duration::ZERO,
        }
    }

    fn step(&mut self) {
        let began = Instant::now();
        self.app.update();
        self.steps += began.elapsed();
        self.broad_phase += self.app.world().resource::<CollisionDiagnostics>().broad_phase;
    }

    /// Where all things are, to the bit.
    fn places(&mut self) -> Vec<[u32; 3]> {
        let world = self.app.world_mut();
        let mut all = world.query::<&Position>();
        let places = all.iter(world).map(|place| place.0.to_array().map(f32::to_bits));
        places.collect()
    }

    /// The pairs in its contact graph.
    fn pairs(&self) -> BTreeSet<[Entity; 2]> {
        let graph = self.app.world().resource::<ContactGraph>();
        let contacts = graph.iter_active().chain(graph.iter_sleeping());
        let pairs = contacts.map(|contact| {
            let mut pair = [contact.collider1, contact.collider2];
            pair.sort_unstable();
            pair
        });
        pairs.collect()
    }
}

/// A box without a lid, and balls above it, in layers that are shifted.
fn spawn(mut commands: Commands, balls: u32) {
    let side = (f64::from(balls).cbrt().ceil() as u32).max(1);
    let half = 0.6 * side as f32 + 1.0;
    for (place, size) in [
        (Vec3::NEG_Y, [2.0 * half, 1.0, 2.0 * half]),
        (Vec3::X * half, [1.0, 4.0 * half, 2.0 * half]),
        (Vec3::NEG_X * half, [1.0, 4.0 * half, 2.0 * half]),
        (Vec3::Z * half, [2.0 * half, 4.0 * half, 1.0]),
        (Vec3::NEG_Z * half, [2.0 * half, 4.0 * half, 1.0]),
    ] {
        let [x, y, z] = size;
        commands.spawn((
            RigidBody::Static,
            Collider::cuboid(x, y, z),
            Transform::from_translation(place),
        ));
    }
    for ball in 0..balls {
        let place = [ball % side, ball / side % side, ball / (side * side)].map(|i| i as f32);
        let shift = 0.25 * (place[2] % 3.0) - 0.25;
        let place = Vec3::new(
            1.15 * (place[0] - 0.5 * side as f32) + shift,
            1.0 + 1.15 * place[2],
            1.15 * (place[1] - 0.5 * side as f32) - 0.5 * shift,
        );
        commands.spawn((
            RigidBody::Dynamic,
            Collider::sphere(0.5),
            Restitution::new(0.5),
            Transform::from_translation(place),
        ));
    }
}
