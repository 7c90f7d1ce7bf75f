//! Measures unisize against every library that finds the pairs of boxes, in one run: a table, JSON lines and a chart.
//!
//! ```text
//! cargo run --release --package unisize-peers -- --json FILE
//! ```
//!
//! Every pair set is compared with that of an oracle before any time of it is reported. Broad phases are measured against Rapier's own
//! in whole scenes, by `benches/compare`.

mod chart;
mod kernels;
mod pair_set;
mod row;
mod times;

use anyhow::Result;
use clap::Parser;
use std::path::PathBuf;
use unisize_report::Report;

/// Measures unisize against its peers: a table on the terminal, JSON lines and a chart.
#[derive(Debug, Parser)]
struct Options {
    /// Few and small cases, to see that everything runs; its figures are rough, and its chart goes to Cargo's target directory
    #[arg(long)]
    quick: bool,
    /// Append the results to this file, a JSON object a line
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

fn main() -> Result<()> {
    let options = Options::parse();
    let mut report = Report::new(options.json.as_deref())?;
    let rows = kernels::measure(options.quick, &mut report)?;
    let figures = match options.quick {
        true => unisize_charts::scratch_folder("peers"),
        false => PathBuf::from("docs/figures"),
    };
    std::fs::create_dir_all(&figures)?;
    chart::draw(&rows, &figures)
}
