//! The command line.

use clap::{Parser, Subcommand};
use std::path::PathBuf;

/// Remakes the tables, charts and pictures of docs/paper.md.
#[derive(Clone, Debug, Parser)]
#[command(name = "paper")]
pub(crate) struct Options {
    #[command(subcommand)]
    part: Option<Part>,
    /// The folder of paper.md and of its pictures, in paper/ [default: docs; with --quick paper in the target directory]
    #[arg(long, global = true, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Few boxes and frames, for a check of a few seconds; its figures are rough
    #[arg(long, global = true)]
    pub(crate) quick: bool,
}

/// A part of the page.
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
    /// The program that runs under valgrind.
    #[command(hide = true)]
    CacheProbe {
        method: crate::cache::Probed,
        count: usize,
        density: f64,
    },
}

impl Options {
    /// The folder of the page. A quick run must not overwrite the published one.
    pub(crate) fn out(&self) -> PathBuf {
        let default = || match self.quick {
            true => unisize_charts::scratch_folder("paper"),
            false => PathBuf::from("docs"),
        };
        self.out.clone().unwrap_or_else(default)
    }

    pub(crate) fn part(&self) -> Part {
        self.part.unwrap_or(Part::All)
    }
}

#[cfg(test)]
mod tests {
    use super::Options;
    use clap::Parser;
    use std::path::Path;

    #[test]
    fn a_quick_run_leaves_the_published_page_alone() {
        let out = |line: &[&str]| Options::parse_from(["paper"].iter().chain(line)).out();
        assert_eq!(out(&[]), Path::new("docs"));
        assert_eq!(out(&["table1"]), Path::new("docs"));
        let scratch = unisize_charts::scratch_folder("paper");
        assert!(!scratch.starts_with("docs"));
        assert_eq!(out(&["--quick"]), scratch);
        assert_eq!(out(&["table1", "--quick"]), scratch);
        assert_eq!(out(&["--quick", "--out", "docs"]), Path::new("docs"));
    }
}
