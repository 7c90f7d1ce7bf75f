//! The command line.

use clap::{Parser, ValueEnum};
use std::path::PathBuf;

/// Measures what updates of a broad phase take, in time and memory, and why.
#[derive(Debug, Parser)]
pub(crate) struct Options {
    /// What to measure [default: everything]
    questions: Vec<Question>,
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
    /// Bytes a collider, ours and Rapier's own
    Memory,
    /// Time and memory a body from a hundred thousand to four million
    Scale,
    /// Boxes on which methods break down
    HardBoxes,
    /// Motions on which broad phases break down
    HardMotions,
    /// A ray in each step, and the age of the tree
    Queries,
}

impl Options {
    pub(crate) fn questions(&self) -> Vec<Question> {
        if self.questions.is_empty() {
            return Question::value_variants().to_vec();
        }
        self.questions.clone()
    }

    /// Whether only to see that everything runs.
    pub(crate) fn is_small(&self) -> bool {
        self.test || !self.bench
    }

    /// The usual number, or the small one.
    pub(crate) fn least<T>(&self, usual: T, small: T) -> T {
        if self.is_small() { small } else { usual }
    }
}
