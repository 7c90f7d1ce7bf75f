//! Measures unisize against every peer, in one run: a table, JSON lines and charts.
//!
//! ```text
//! cargo run --release --package unisize-peers -- --json FILE
//! ```
//!
//! [`kernels`] finds the pairs of boxes of one moment, [`updates`] follows them over time, as a broad phase of
//! Rapier does. Every pair set is compared with that of an oracle before any time of it is reported.

#[path = "../../common/case.rs"]
mod case;
mod chart;
#[path = "../../common/clock.rs"]
mod clock;
#[path = "../../common/json_lines.rs"]
mod json_lines;
mod kernels;
mod pair_set;
#[path = "../../../examples/progress/bar.rs"]
mod progress;
#[path = "../../common/report.rs"]
mod report;
mod row;
mod times;
mod updates;

use anyhow::Result;
use clap::{Parser, ValueEnum};
use report::Report;
use std::path::PathBuf;

/// Measures unisize against its peers: a table on the terminal, JSON lines and charts.
#[derive(Debug, Parser)]
struct Options {
    /// Few and small cases, to see that everything runs; its figures are rough, and its charts go to Cargo's target directory
    #[arg(long)]
    quick: bool,
    /// Measure only these
    #[arg(long, value_name = "WHAT")]
    only: Option<Subject>,
    /// Append the results to this file, a JSON object a line
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// What can be measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Subject {
    /// The pairs of boxes of one moment
    Kernels,
    /// Broad phases over time
    Updates,
}

fn main() -> Result<()> {
    let options = Options::parse();
    let mut report = Report::new(options.json.as_deref())?;
    let mut rows = Vec::new();
    if options.only != Some(Subject::Updates) {
        rows.extend(kernels::measure(options.quick, &mut report)?);
    }
    if options.only != Some(Subject::Kernels) {
        rows.extend(updates::measure(options.quick, &mut report)?);
    }
    let figures = match options.quick {
        true => unisize_charts::scratch_folder("peers"),
        false => PathBuf::from("docs/figures"),
    };
    std::fs::create_dir_all(&figures)?;
    chart::draw(&rows, &figures)
}
