//! The paper beside this library: what it claims, its figures and ours.
//!
//! ```text
//! cargo run --release --manifest-path benches/Cargo.toml --package paper
//! ```
//!
//! prints every table of `docs/dev/paper.md`, and at the end the claims of the paper with a verdict each. `--page docs/dev/paper.md` writes
//! the tables into the page, between the comments that name them, and `--pictures docs/dev/paper` draws its pictures there. The names
//! of parts remake those alone:
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
mod table;
mod table1;
mod third_axis;
mod threads;

use anyhow::{Context, Result};
use clap::Parser;
use clap::builder::PossibleValuesParser;
use std::path::PathBuf;
use table::Table;

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
    /// Append the figures to this file as well, a line of JSON for each
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Writes the tables into this page as well
    #[arg(long, value_name = "FILE")]
    page: Option<PathBuf>,
    /// The folder of the pictures [default: paper in the target directory]
    #[arg(long, value_name = "DIR")]
    pictures: Option<PathBuf>,
    /// Few boxes and frames, for a check of a few seconds; its figures are rough
    #[arg(long)]
    quick: bool,
}

/// What the parts measure, and where to.
struct Run {
    quick: bool,
    pictures: PathBuf,
    table: Table,
}

impl Run {
    /// The first in a quick run, otherwise the second.
    fn choose<T>(&self, quick: T, full: T) -> T {
        if self.quick { quick } else { full }
    }

    /// Two to the power of `size`, the number of squares; a quick run has fewer.
    fn squares(&self, size: u32) -> usize {
        self.choose(1 << (size - 7), 1 << size)
    }
}

fn main() -> Result<()> {
    let options = Options::parse();
    let pictures = options.pictures;
    let pictures = pictures.unwrap_or_else(|| unisize_charts::scratch_folder("paper"));
    let cannot = || format!("cannot create {}", pictures.display());
    std::fs::create_dir_all(&pictures).with_context(cannot)?;
    let mut run = Run {
        quick: options.quick,
        pictures,
        table: Table::default(),
    };
    let is_chosen =
        |name: &str| options.parts.is_empty() || options.parts.iter().any(|p| p == name);
    // Everything runs on one thread, as in the paper; the part about threads makes its own pools.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    for (name, measure) in PARTS.into_iter().filter(|(name, _)| is_chosen(name)) {
        eprintln!("{name}");
        pool.install(|| measure(&mut run))?;
    }
    if !run.quick {
        claims::judge(&mut run.table);
    }
    println!("{}", run.table);
    run.table.append_to(options.json.as_deref())?;
    match &options.page {
        Some(page) => run.table.write_into(page),
        None => Ok(()),
    }
}
