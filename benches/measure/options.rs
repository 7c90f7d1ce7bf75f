//! The command line.

use clap::{Parser, ValueEnum};
use std::path::PathBuf;
use unisize_scenes::SceneKind;

/// Measures what updates of a broad phase take, in time and memory, and why.
#[derive(Debug, Parser)]
pub(crate) struct Options {
    /// What to measure [default: everything]
    questions: Vec<Question>,
    /// A scene for the prices; may be given several times [default: every scene]
    #[arg(long = "scene", value_name = "NAME", value_parser = parse_scene)]
    scenes: Vec<SceneKind>,
    /// Append the results to this file, a JSON object a line
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
    /// Few and small cases, to see that everything runs; also without the `--bench` that Cargo gives
    #[arg(long)]
    test: bool,
    #[arg(long, hide = true)]
    bench: bool,
}

/// What can be measured.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Question {
    /// The phases of the kernel, beside a lower bound
    Kernels,
    /// Updates of colliders: times, phases and memory, ours and Rapier's own
    Updates,
    /// Time and memory a body from a hundred thousand to four million; draws docs/figures/scale.svg
    Scale,
    /// Boxes on which methods break down
    HardBoxes,
    /// Motions on which broad phases break down
    HardMotions,
    /// A ray in each step, and the age of the tree
    Queries,
    /// What units of work cost, and foresight by speed beside fixed ones
    Prices,
}

impl Options {
    pub(crate) fn questions(&self) -> Vec<Question> {
        if self.questions.is_empty() {
            return Question::value_variants().to_vec();
        }
        self.questions.clone()
    }

    pub(crate) fn scenes(&self) -> Vec<SceneKind> {
        if self.scenes.is_empty() {
            return SceneKind::ALL.to_vec();
        }
        self.scenes.clone()
    }

    /// Whether only to see that everything runs.
    pub(crate) fn is_small(&self) -> bool {
        self.test || !self.bench
    }

    /// The usual number, or the small one.
    pub(crate) fn least<T>(&self, usual: T, small: T) -> T {
        if self.is_small() { small } else { usual }
    }

    /// These numbers, but in a small run none above this one.
    pub(crate) fn counts<'a>(&self, counts: &'a [usize], most: usize) -> Vec<&'a usize> {
        let is_small_enough = |count: &&usize| !self.is_small() || **count <= most;
        counts.iter().filter(is_small_enough).collect()
    }

    /// Balls, and one in how many moves.
    pub(crate) fn queries(&self) -> Vec<(usize, usize)> {
        let all = [(10_000, 1), (10_000, 10), (10_000, 100), (1_000, 1)];
        let mut cases = self.least(all.to_vec(), Vec::new());
        cases.push((10, 1));
        cases
    }
}

fn parse_scene(name: &str) -> Result<SceneKind, String> {
    SceneKind::from_name(name).ok_or_else(|| "there is no such scene".to_owned())
}
