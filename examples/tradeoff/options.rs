//! The command line.

use crate::method::Method;
use clap::builder::RangedU64ValueParser;
use clap::error::ErrorKind;
use clap::{CommandFactory, Parser, ValueEnum};
use std::path::PathBuf;
use unisize_scenes::SceneKind;

/// The scenes to choose from. None of them removes a collider, because the replay cannot pass on removals.
const SCENES: [SceneKind; 6] = [
    SceneKind::Ropes,
    SceneKind::Hopper,
    SceneKind::Crowd,
    SceneKind::MixedEight,
    SceneKind::Gas,
    SceneKind::Sleeping,
];

/// A scene of the study of what is missed alone: there, contacts come and go between two steps.
const FAST_SCENE: SceneKind = SceneKind::Bullets;

/// Bodies and steps with `--quick`.
const QUICK_BODIES: usize = 120;
const QUICK_STEPS: usize = 40;

/// Steps otherwise: four seconds, and fewer in the study of what is missed, which has three times as many methods.
const STEPS: usize = 240;
const MISSED_STEPS: usize = 80;

/// Steps before those that are measured, in the study of what is missed: by then, things touch in every scene.
const LEAD_IN: usize = 140;
const QUICK_LEAD_IN: usize = 80;

/// Simulations that are not timed have no more bodies than this.
const COURSE_BODIES: usize = 400;

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Study {
    /// What each kernel and margin costs, and that none misses a pair
    Margins,
    /// What methods miss that trade accuracy for speed, and how fast they are
    Missed,
}

/// Measures what each broad phase and margin costs, and whether it misses pairs.
#[derive(Clone, Debug, Parser)]
#[command(name = "tradeoff")]
pub(super) struct Options {
    /// What to measure
    #[arg(long, value_enum, default_value = "margins")]
    pub(super) study: Study,
    /// A scene to measure on; may be given several times [default: all of them]
    #[arg(long, value_name = "SCENE", value_parser = parse_scene)]
    only: Vec<SceneKind>,
    /// About how many bodies per scene [default: 2,000, of ropes and bullets 1,000; with --quick 120]
    #[arg(long, value_name = "N", value_parser = between(1, 1_000_000))]
    bodies: Option<usize>,
    /// How many steps to simulate [default: 240, of what is missed 80; with --quick 40]
    #[arg(long, value_name = "N", value_parser = between(1, 1_000_000))]
    steps: Option<usize>,
    /// How often each step is measured with each method [default: 3; with --quick 1]
    #[arg(long, value_name = "N", value_parser = between(1, 100))]
    repeats: Option<usize>,
    /// The seed of the scenes' randomness
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub(super) seed: u64,
    /// The folder of the charts [default: docs/figures; with --quick tradeoff in the target directory]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Few bodies and steps, for a check of a few seconds; its figures are rough
    #[arg(long)]
    quick: bool,
}

impl Options {
    /// The options of the command line; ends the program if they do not go together.
    pub(super) fn of_command_line() -> Self {
        let options = Self::parse();
        if options.study == Study::Margins && options.only.contains(&FAST_SCENE) {
            let message = format!("{} are measured with --study missed", FAST_SCENE.name());
            let mut command = Self::command();
            command.error(ErrorKind::ArgumentConflict, message).exit();
        }
        options
    }

    pub(super) fn scenes(&self) -> Vec<SceneKind> {
        if !self.only.is_empty() {
            return self.only.clone();
        }
        let fast = (self.study == Study::Missed).then_some(FAST_SCENE);
        SCENES.into_iter().chain(fast).collect()
    }

    /// The folder of the charts. A quick run must not overwrite the published ones.
    pub(super) fn out(&self) -> PathBuf {
        let default = || match self.quick {
            true => unisize_charts::scratch_folder("tradeoff"),
            false => PathBuf::from("docs/figures"),
        };
        self.out.clone().unwrap_or_else(default)
    }

    /// The number of bodies where broad phases are timed.
    pub(super) fn bodies(&self, kind: SceneKind) -> usize {
        self.bodies.unwrap_or(match kind {
            _ if self.quick => QUICK_BODIES,
            SceneKind::Ropes | SceneKind::Bullets => 1_000,
            _ => 2_000,
        })
    }

    /// The number of bodies of the simulations on one method each.
    pub(super) fn course_bodies(&self, kind: SceneKind) -> usize {
        self.bodies(kind).min(COURSE_BODIES)
    }

    pub(super) fn steps(&self) -> usize {
        self.steps.unwrap_or(match self.study {
            _ if self.quick => QUICK_STEPS,
            Study::Margins => STEPS,
            Study::Missed => MISSED_STEPS,
        })
    }

    /// Steps before those that are measured, in the study of what is missed.
    pub(super) fn lead_in(&self) -> usize {
        match self.quick {
            true => QUICK_LEAD_IN,
            false => LEAD_IN,
        }
    }

    pub(super) fn repeats(&self) -> usize {
        self.repeats.unwrap_or(if self.quick { 1 } else { 3 })
    }

    /// The pairs held are compared with those that touch once in this many steps.
    pub(super) fn truth_every(&self) -> usize {
        self.steps().div_ceil(24)
    }

    /// The same, but odd: of every two, four or eight steps, each is examined equally often.
    pub(super) fn odd_truth_every(&self) -> usize {
        self.truth_every() | 1
    }

    /// All steps of all simulations.
    pub(super) fn total_steps(&self) -> usize {
        let of_kind = |kind: &SceneKind| {
            let replay = self.steps();
            let courses = match self.study {
                Study::Margins => Method::courses(self.course_bodies(*kind)) * self.steps(),
                Study::Missed => 0,
            };
            2 * (replay + courses)
        };
        self.scenes().iter().map(of_kind).sum()
    }
}

fn between(low: u64, high: u64) -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(low..=high)
}

fn parse_scene(name: &str) -> Result<SceneKind, String> {
    let mut scenes = SCENES.into_iter().chain([FAST_SCENE]);
    scenes.find(|kind| kind.name() == name).ok_or_else(|| {
        let names = SCENES.map(SceneKind::name).join(", ");
        let fast = FAST_SCENE.name();
        format!("there is no such scene here; there are {names}, {fast}")
    })
}

#[cfg(test)]
mod tests {
    use super::{Options, SCENES};
    use clap::Parser;
    use std::path::Path;

    #[test]
    fn a_quick_run_leaves_the_published_charts_alone() {
        let out = |line: &[&str]| Options::parse_from(["tradeoff"].iter().chain(line)).out();
        assert_eq!(out(&[]), Path::new("docs/figures"));
        let scratch = unisize_charts::scratch_folder("tradeoff");
        assert!(!scratch.starts_with("docs"));
        assert_eq!(out(&["--quick"]), scratch);
        assert_eq!(out(&["--quick", "--out", "docs"]), Path::new("docs"));
    }

    #[test]
    fn studies_have_scenes_and_steps_of_their_own() {
        let options = |line: &[&str]| Options::parse_from(["tradeoff"].iter().chain(line));
        let [margins, missed] = [options(&[]), options(&["--study", "missed"])];
        assert_eq!(margins.scenes(), SCENES);
        assert_eq!(missed.scenes().len(), SCENES.len() + 1);
        assert_eq!([margins.steps(), missed.steps()], [240, 80]);
        assert_eq!(missed.total_steps(), 7 * 2 * 80);
        for steps in 1..300 {
            let steps = steps.to_string();
            assert_eq!(options(&["--steps", &steps]).odd_truth_every() % 2, 1);
        }
    }
}
