//! The command line.

use crate::method::Method;
use clap::Parser;
use clap::builder::RangedU64ValueParser;
use std::path::PathBuf;
use unisize_scenes::SceneKind;

/// The scenes to choose from: none of them removes a collider, which the replay could not show to a broad phase.
const SCENES: [SceneKind; 6] = [
    SceneKind::Ropes,
    SceneKind::Hopper,
    SceneKind::Crowd,
    SceneKind::MixedEight,
    SceneKind::Gas,
    SceneKind::Sleeping,
];

/// How many bodies and steps `--quick` has.
const QUICK_BODIES: usize = 120;
const QUICK_STEPS: usize = 40;

/// How many steps there are otherwise: four seconds.
const STEPS: usize = 240;

/// Simulations of which nothing is timed have no more bodies than this.
const COURSE_BODIES: usize = 400;

/// Measures what each broad phase and margin costs, and whether it misses anything.
#[derive(Clone, Debug, Parser)]
#[command(name = "tradeoff")]
pub(super) struct Options {
    /// A scene to measure on; may be given several times [default: all of them]
    #[arg(long, value_name = "SCENE", value_parser = parse_scene)]
    only: Vec<SceneKind>,
    /// About how many bodies in every scene [default: 2,000, of ropes 1,000; or 120 with --quick]
    #[arg(long, value_name = "N", value_parser = between(1, 1_000_000))]
    bodies: Option<usize>,
    /// How many steps to simulate [default: 240, or 40 with --quick]
    #[arg(long, value_name = "N", value_parser = between(1, 1_000_000))]
    steps: Option<usize>,
    /// How many times each step is measured with each method [default: 3, or 1 with --quick]
    #[arg(long, value_name = "N", value_parser = between(1, 100))]
    repeats: Option<usize>,
    /// The seed of the scenes' randomness
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(super) seed: u64,
    /// The charts are drawn into docs/figures of this folder
    #[arg(long, value_name = "DIR", default_value = ".")]
    pub(super) out: PathBuf,
    /// Few bodies and steps, for a check of a few seconds
    #[arg(long)]
    quick: bool,
}

impl Options {
    pub(super) fn scenes(&self) -> Vec<SceneKind> {
        if self.only.is_empty() {
            SCENES.to_vec()
        } else {
            self.only.clone()
        }
    }

    /// How many bodies a scene has in which broad phases are timed.
    pub(super) fn bodies(&self, kind: SceneKind) -> usize {
        self.bodies.unwrap_or(match kind {
            _ if self.quick => QUICK_BODIES,
            SceneKind::Ropes => 1_000,
            _ => 2_000,
        })
    }

    /// How many bodies a scene has that is simulated on each broad phase alone.
    pub(super) fn course_bodies(&self, kind: SceneKind) -> usize {
        self.bodies(kind).min(COURSE_BODIES)
    }

    pub(super) fn steps(&self) -> usize {
        self.steps
            .unwrap_or(if self.quick { QUICK_STEPS } else { STEPS })
    }

    pub(super) fn repeats(&self) -> usize {
        self.repeats.unwrap_or(if self.quick { 1 } else { 3 })
    }

    /// What is held is compared with what touches at every such number of steps.
    pub(super) fn truth_every(&self) -> usize {
        self.steps().div_ceil(24)
    }

    /// All steps of all simulations.
    pub(super) fn total_steps(&self) -> usize {
        let of_kind = |kind: &SceneKind| {
            let replay = self.steps();
            let courses = Method::courses(self.course_bodies(*kind)) * self.steps();
            2 * (replay + courses)
        };
        self.scenes().iter().map(of_kind).sum()
    }
}

fn between(low: u64, high: u64) -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(low..=high)
}

fn parse_scene(name: &str) -> Result<SceneKind, String> {
    let mut scenes = SCENES.into_iter();
    scenes.find(|kind| kind.name() == name).ok_or_else(|| {
        let names = SCENES.map(SceneKind::name).join(", ");
        format!("there is no such scene here; there are {names}")
    })
}
