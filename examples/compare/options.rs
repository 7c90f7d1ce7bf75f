//! The command line.

use clap::builder::RangedU64ValueParser;
use clap::{Parser, ValueEnum};
use std::path::PathBuf;
use unisize_scenes::SceneKind;

/// How many bodies `--quick` gives a scene.
const QUICK_BODIES: usize = 150;

/// How many steps `--quick` simulates.
const QUICK_STEPS: usize = 40;

/// How many steps are simulated otherwise: five seconds.
const STEPS: usize = 300;

/// Compares unisize with Rapier's own broad phase, on every scene.
///
/// The default broad phase drives the simulation, and unisize gets the same updates. After every step the pairs
/// that they hold, and the contacts and intersections that follow, are compared. Then each scene is simulated
/// on either broad phase alone. Exits with 1 if anything differs.
#[derive(Clone, Debug, Parser)]
#[command(name = "compare")]
pub(super) struct Options {
    /// A scene to compare on; may be given several times [default: every scene]
    #[arg(long = "scene", value_name = "NAME", value_parser = parse_scene)]
    scenes: Vec<SceneKind>,
    /// In how many dimensions
    #[arg(long, value_enum, default_value = "both")]
    dim: Dim,
    /// About how many bodies in every scene [default: each scene's own number]
    #[arg(long, value_name = "N", value_parser = between(1, 10_000_000))]
    bodies: Option<usize>,
    /// How many steps to simulate [default: 300, or 40 with --quick]
    #[arg(long, value_name = "N", value_parser = between(1, 1_000_000))]
    steps: Option<usize>,
    /// What finds the pairs in unisize
    #[arg(long, value_enum, default_value = "grid-sweep")]
    pub(super) kernel: Kernel,
    /// How many threads unisize may use, which pays only for very many bodies; Rapier's own uses one
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = between(1, 1_024))]
    pub(super) threads: usize,
    /// The seed of the scenes' randomness
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(super) seed: u64,
    /// Write the results to this file as well
    #[arg(long, value_name = "FILE")]
    pub(super) json: Option<PathBuf>,
    /// Few bodies and steps, for a check of a few seconds
    #[arg(long)]
    quick: bool,
    /// Check unisize's internal invariants after every step
    #[arg(long)]
    pub(super) validate: bool,
    /// Leave out the simulations on either broad phase alone
    #[arg(long)]
    no_independent: bool,
    /// Compute and compare the contacts only at every N-th step and the last
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = between(1, 1_000_000))]
    pub(super) contacts_every: usize,
}

impl Options {
    pub(super) fn dims(&self) -> impl Iterator<Item = u8> {
        let dims: &[u8] = match self.dim {
            Dim::Two => &[2],
            Dim::Three => &[3],
            Dim::Both => &[2, 3],
        };
        dims.iter().copied()
    }

    pub(super) fn scenes(&self) -> impl Iterator<Item = SceneKind> {
        let scenes = if self.scenes.is_empty() {
            SceneKind::ALL.to_vec()
        } else {
            self.scenes.clone()
        };
        scenes.into_iter()
    }

    pub(super) fn bodies(&self, kind: SceneKind) -> usize {
        self.bodies.unwrap_or(if self.quick {
            QUICK_BODIES
        } else {
            kind.default_bodies()
        })
    }

    pub(super) fn steps(&self) -> usize {
        self.steps
            .unwrap_or(if self.quick { QUICK_STEPS } else { STEPS })
    }

    pub(super) fn independent(&self) -> bool {
        !self.no_independent
    }

    /// All steps of all simulations.
    pub(super) fn total_steps(&self) -> usize {
        let runs = if self.independent() { 3 } else { 1 };
        self.dims().count() * self.scenes().count() * self.steps() * runs
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Dim {
    #[value(name = "2")]
    Two,
    #[value(name = "3")]
    Three,
    Both,
}

/// The kernels of unisize.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Kernel {
    /// The fast one
    GridSweep,
    /// The algorithm of Capannini and Larsson
    RankSweep,
    /// Every box against every other
    BruteForce,
}

impl Kernel {
    pub(super) fn name(self) -> String {
        let value = self.to_possible_value();
        value.map_or_else(String::new, |value| value.get_name().to_owned())
    }
}

fn between(low: u64, high: u64) -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(low..=high)
}

fn parse_scene(name: &str) -> Result<SceneKind, String> {
    SceneKind::from_name(name).ok_or_else(|| {
        let names = SceneKind::ALL.map(SceneKind::name).join(", ");
        format!("there is no such scene; there are {names}")
    })
}
