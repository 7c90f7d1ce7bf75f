//! The paper beside this library: what it claims, its figures and ours.
//!
//! ```text
//! cargo run --release --manifest-path benches/Cargo.toml --package paper
//! ```
//!
//! prints every table of `docs/dev/paper.md` and some more, and at the end the claims of the paper with a verdict each. With `--json FILE` it
//! appends the rows to a file as well, from which `.ci/tables` and `.ci/chart` make the tables and the chart of the page. The names of parts
//! measure those alone:
//!
//! ```text
//! cargo run --release --manifest-path benches/Cargo.toml --package paper -- table1 figure3
//! ```
//!
//! All methods get the same boxes in the same frames, in turns. The program exits with 1 if they find different pairs or if it
//! cannot write, and with 2 if it was called wrongly.

mod claims;
mod figure3;
mod figure4;
mod published;
mod race;
mod run;
mod table1;
mod third_axis;
mod threads;

use anyhow::Result;
use clap::Parser;
use clap::builder::PossibleValuesParser;
use run::Run;
use std::path::PathBuf;

/// A part of the page, and what measures it.
type Part = (&'static str, fn(&mut Run) -> Result<()>);

const PARTS: [Part; 5] = [
    ("table1", table1::measure),
    ("figure3", figure3::measure),
    ("figure4", figure4::measure),
    ("third-axis", third_axis::measure),
    ("threads", threads::measure),
];

/// Measures what docs/dev/paper.md shows.
#[derive(Clone, Debug, Parser)]
#[command(name = "paper")]
struct Options {
    /// The parts to measure [default: all]
    #[arg(value_parser = PossibleValuesParser::new(PARTS.map(|(name, _)| name)))]
    parts: Vec<String>,
    /// Append the figures to this file as well, a line of JSON for each row
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Few boxes and frames, for a check of a few seconds; its figures are rough
    #[arg(long)]
    quick: bool,
}

fn main() -> Result<()> {
    let options = Options::parse();
    let mut run = Run::new(options.quick, options.json.as_deref())?;
    let is_chosen =
        |name: &str| options.parts.is_empty() || options.parts.iter().any(|p| p == name);
    // Everything runs on one thread, as in the paper; the part about threads makes its own pools.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    for (_, measure) in PARTS.into_iter().filter(|(name, _)| is_chosen(name)) {
        pool.install(|| measure(&mut run))?;
    }
    if !run.quick {
        claims::judge(&mut run)?;
    }
    Ok(())
}
