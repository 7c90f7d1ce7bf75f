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

    /// The folder that gets `benches/results/<machine>.csv` and `docs/figures/peers-*.svg`
    #[arg(long, value_name = "DIR", default_value = ".")]
    pub(crate) out: PathBuf,

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
    pub(crate) fn covers(&self, subject: Subject) -> bool {
        self.only.is_none_or(|only| only == subject)
    }

    /// The name of the machine, fit for a file.
    pub(crate) fn machine(&self) -> String {
        machine::file_name(&self.machine.clone().unwrap_or_else(machine::description))
    }
}
