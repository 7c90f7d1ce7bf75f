//! The command line.

use clap::{Parser, Subcommand};
use std::path::PathBuf;

/// Remakes the tables, charts and pictures of docs/paper.md.
#[derive(Clone, Debug, Parser)]
#[command(name = "paper")]
pub(crate) struct Options {
    #[command(subcommand)]
    part: Option<Part>,
    /// The folder of paper.md, with a folder paper of its pictures
    #[arg(long, global = true, value_name = "DIR", default_value = "docs")]
    pub(crate) out: PathBuf,
    /// Few boxes and frames, for a check of a few seconds
    #[arg(long, global = true)]
    pub(crate) quick: bool,
}

/// What to remake.
#[derive(Clone, Copy, Debug, PartialEq, Subcommand)]
pub(crate) enum Part {
    /// All of the following, which is also the default
    All,
    /// Times of all methods for squares that drift about
    #[command(name = "table1")]
    Table1,
    /// Time per collision of the pairing phase
    #[command(name = "figure3")]
    Figure3,
    /// Squares that converge on the centre
    #[command(name = "figure4")]
    Figure4,
    /// Planar, layered and fully three-dimensional scenes
    ThirdAxis,
    /// Sorting and pairing in parallel
    Threads,
    /// Cache misses of the pairing phase; needs valgrind
    Cache,
    /// Continuous motion
    Continuous,
    /// Crowds, chains and particles
    Applications,
    /// What runs under valgrind.
    #[command(hide = true)]
    CacheProbe {
        method: crate::cache::Probed,
        count: usize,
        density: f64,
    },
}

impl Options {
    pub(crate) fn part(&self) -> Part {
        self.part.unwrap_or(Part::All)
    }
}
