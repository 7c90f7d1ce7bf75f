//! Measures unisize against every peer, in one run, and writes a table, a CSV file and charts.
//!
//! ```text
//! cargo run --release --package unisize-peers
//! ```
//!
//! [`kernels`] finds the pairs of boxes of one moment, [`updates`] follows them over time, as a broad phase of
//! Rapier does. Every pair set is compared with that of an oracle before any time of it is reported.

mod chart;
#[path = "../../common/clock.rs"]
mod clock;
mod kernels;
mod latency;
mod machine;
mod options;
mod pair_set;
mod progress;
mod row;
mod table;
mod times;
mod updates;

use anyhow::{Context, Result};
use clap::Parser;
use options::{Options, Subject};
use progress::Progress;
use row::Row;
use std::path::Path;

fn main() -> Result<()> {
    let options = Options::parse();
    let machine = options.machine();
    let progress = Progress::new();

    let results = options.out().join("benches/results");
    let figures = options.out().join("docs/figures");
    let file = results.join(format!("{machine}.csv"));
    if options.redraw {
        let rows =
            row::read_csv(&file).with_context(|| format!("cannot read {}", file.display()))?;
        return draw(&rows, &figures);
    }

    let mut rows = Vec::new();
    if options.covers(Subject::Kernels) {
        rows.extend(kernels::measure(options.quick, &progress)?);
    }
    if options.covers(Subject::Updates) {
        rows.extend(updates::measure(options.quick, &progress)?);
    }
    progress.finish();

    println!("Machine: {machine}\n");
    table::print(&rows);
    latency::print(&rows);

    for folder in [&results, &figures] {
        std::fs::create_dir_all(folder)
            .with_context(|| format!("cannot create {}", folder.display()))?;
    }
    row::write_csv(&rows, &file).with_context(|| format!("cannot write {}", file.display()))?;
    println!("Written: {}", file.display());
    draw(&rows, &figures)?;
    println!();
    kernels::check_streamed(&rows)
}

fn draw(rows: &[Row], figures: &Path) -> Result<()> {
    for file in chart::draw(rows, figures)? {
        println!("Written: {}", file.display());
    }
    Ok(())
}
