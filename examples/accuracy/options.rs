//! The command line.

use crate::scene::Scene;
use clap::builder::RangedU64ValueParser;
use clap::{Parser, ValueEnum};
use std::path::PathBuf;

/// Seeds of a full run, and of a quick one.
const SEEDS: u64 = 20;
const QUICK_SEEDS: u64 = 2;

/// A quick run has so many bodies at most, and simulates this part of the time.
const QUICK_BODIES: usize = 40;
const QUICK_TIME: f64 = 0.4;

/// Error against computing time for one simulated second, on Rapier's own broad phase and on unisize.
///
/// Each scene is simulated with four time steps, from starts that differ a little by their seed. A test on the same starts says
/// whether the two can be told apart, and a negative control, which loses one pair in a thousand, whether the test would notice.
/// What is told apart is simulated again with the events of both in the same order. Exits with 1 if that differs too, or if the
/// control is told apart in no scene, and with 2 if it cannot write.
#[derive(Clone, Debug, Parser)]
#[command(name = "accuracy")]
pub(super) struct Options {
    /// A scene to measure; may be given several times [default: all of them]
    #[arg(long = "scene", value_name = "NAME", value_parser = Scene::groups())]
    scenes: Vec<String>,
    /// In how many dimensions
    #[arg(long, value_enum, default_value = "both")]
    dim: Dim,
    /// How many seeds; fewer than 15 give no verdict [default: 20; with --quick 2]
    #[arg(long, value_name = "N", value_parser = RangedU64ValueParser::<u64>::new().range(1..=1000))]
    seeds: Option<u64>,
    /// The first seed: another one gives another sample of the same ensemble
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u32,
    /// The folder of the charts [default: docs/figures; with --quick, --seeds or --scene, accuracy in the target directory]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Few bodies, seeds and steps, for a check of some seconds, which gives no verdict
    #[arg(long)]
    pub(super) quick: bool,
}

impl Options {
    pub(super) fn dims(&self) -> &'static [u8] {
        match self.dim {
            Dim::Two => &[2],
            Dim::Three => &[3],
            Dim::Both => &[2, 3],
        }
    }

    pub(super) fn scenes(&self) -> Vec<Scene> {
        let is_chosen = |scene: &Scene| {
            self.scenes.is_empty() || self.scenes.iter().any(|name| name == scene.group())
        };
        Scene::ALL.into_iter().filter(is_chosen).collect()
    }

    pub(super) fn seeds(&self) -> Vec<u64> {
        let default = if self.quick { QUICK_SEEDS } else { SEEDS };
        let first = u64::from(self.seed);
        (first..first + self.seeds.unwrap_or(default)).collect()
    }

    pub(super) fn bodies(&self, scene: Scene) -> usize {
        match self.quick {
            true => scene.bodies().min(QUICK_BODIES),
            false => scene.bodies(),
        }
    }

    pub(super) fn seconds(&self, scene: Scene) -> f64 {
        match self.quick {
            true => scene.seconds() * QUICK_TIME,
            false => scene.seconds(),
        }
    }

    /// The folder of the charts. Rough figures must not overwrite the published ones.
    pub(super) fn out(&self) -> PathBuf {
        let is_full = !self.quick && self.scenes.is_empty() && self.seeds.is_none();
        let default = || match is_full {
            true => PathBuf::from("docs/figures"),
            false => unisize_charts::scratch_folder("accuracy"),
        };
        self.out.clone().unwrap_or_else(default)
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

#[cfg(test)]
mod tests {
    use super::Options;
    use clap::Parser;
    use std::path::Path;

    fn parse(line: &[&str]) -> Options {
        Options::parse_from(["accuracy"].iter().chain(line))
    }

    #[test]
    fn a_rough_run_leaves_the_published_charts_alone() {
        assert_eq!(parse(&[]).out(), Path::new("docs/figures"));
        for rough in [&["--quick"][..], &["--seeds", "3"], &["--scene", "ropes"]] {
            assert!(!parse(rough).out().starts_with("docs"));
        }
        let chosen = parse(&["--quick", "--out", "docs"]);
        assert_eq!(chosen.out(), Path::new("docs"));
    }

    #[test]
    fn seeds_and_scenes_are_those_asked_for() {
        assert_eq!(parse(&[]).seeds().len(), 20);
        assert_eq!(parse(&["--seeds", "3", "--seed", "7"]).seeds(), [7, 8, 9]);
        assert_eq!(parse(&[]).scenes().len(), 10);
        assert_eq!(parse(&["--scene", "bullets"]).scenes().len(), 3);
        assert!(Options::try_parse_from(["accuracy", "--scene", "nothing"]).is_err());
    }
}
