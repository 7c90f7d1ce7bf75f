//! Measures unisize against every library that finds the pairs of boxes, in one run: a table and JSON lines.
//!
//! ```text
//! cargo run --release --package unisize-peers -- --json FILE
//! ```
//!
//! Every pair set is compared with that of an oracle before any time of it is reported. Broad phases are measured against Rapier's own
//! in whole scenes, by `benches/compare`.

mod kernels;
mod pair_set;
mod times;

use anyhow::Result;
use clap::Parser;
use std::path::PathBuf;
use unisize_report::Report;

/// Measures unisize against its peers: a table on the terminal, and JSON lines.
#[derive(Debug, Parser)]
struct Options {
    /// Few and small cases, to see that everything runs; its figures are rough
    #[arg(long)]
    quick: bool,
    /// Append the results to this file, a JSON object a line
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

fn main() -> Result<()> {
    let options = Options::parse();
    let mut report = Report::new(options.json.as_deref())?;
    kernels::measure(options.quick, &mut report)
}
