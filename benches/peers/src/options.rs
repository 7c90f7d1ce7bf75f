//! The command line.

use crate::machine;
use clap::{Parser, ValueEnum};
use std::path::PathBuf;

/// Measures unisize against its peers: a table on the terminal, a CSV file and charts.
#[derive(Debug, Parser)]
pub(crate) struct Options {
    /// Few and small cases, to see that everything runs; its figures are rough
    #[arg(long)]
    pub(crate) quick: bool,

    /// Measure nothing, but draw the charts again from what was measured
    #[arg(long, conflicts_with_all = ["quick", "only"])]
    pub(crate) redraw: bool,

    /// Measure only these
    #[arg(long, value_name = "WHAT")]
    only: Option<Subject>,

    /// The folder that gets `benches/results/<machine>.csv` and `docs/figures/peers-*.svg` [default: the current one, or
    /// peers in Cargo's target directory with --quick]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,

    /// What the machine is called in the name of the CSV file [default: its processor and cores]
    #[arg(long, value_name = "NAME")]
    machine: Option<String>,
}

/// What can be measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Subject {
    /// The pairs of boxes of one moment
    Kernels,
    /// Broad phases over time
    Updates,
}

impl Options {
    /// The folder of all results. A quick run must not overwrite the published ones.
    pub(crate) fn out(&self) -> PathBuf {
        let default = || match self.quick {
            true => unisize_charts::scratch_folder("peers"),
            false => PathBuf::from("."),
        };
        self.out.clone().unwrap_or_else(default)
    }

    pub(crate) fn covers(&self, subject: Subject) -> bool {
        self.only.is_none_or(|only| only == subject)
    }

    /// The name of the machine, fit for a file.
    pub(crate) fn machine(&self) -> String {
        machine::file_name(&self.machine.clone().unwrap_or_else(machine::description))
    }
}

#[cfg(test)]
mod tests {
    use super::Options;
    use clap::Parser;
    use std::path::Path;

    #[test]
    fn a_quick_run_leaves_the_published_results_alone() {
        let out = |line: &[&str]| Options::parse_from(["peers"].iter().chain(line)).out();
        assert_eq!(out(&[]), Path::new("."));
        assert_eq!(out(&["--redraw"]), Path::new("."));
        assert_eq!(out(&["--quick"]), unisize_charts::scratch_folder("peers"));
        assert_eq!(out(&["--quick", "--out", "."]), Path::new("."));
    }
}
