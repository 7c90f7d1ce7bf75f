//! The paper beside this library: what it claims, its figures and ours.
//!
//! ```text
//! cargo run --release --features rapier2d-027,rapier3d-027,parallel --example paper
//! ```
//!
//! prints every table of `docs/paper.md`, and at the end the claims of the paper with a verdict each. `--page docs/paper.md` writes
//! the tables into the page, between the comments that name them, and `--pictures docs/paper` draws its pictures there. The names
//! of parts remake those alone:
//!
//! ```text
//! cargo run --release --features rapier2d-027,rapier3d-027,parallel --example paper -- table1 figure3
//! ```
//!
//! All methods get the same boxes in the same frames, in turns. The program exits with 1 if they find different pairs or if it
//! cannot write, and with 2 if it was called wrongly.

mod chains;
mod claims;
mod continuous;
mod figure3;
mod figure4;
mod method;
mod published;
mod race;
mod stampede;
mod table;
mod table1;
mod third_axis;
mod threads;

use anyhow::{Context, Result};
use clap::{Parser, ValueEnum};
use std::path::PathBuf;
use std::process::ExitCode;
use table::Table;

/// Measures what docs/paper.md shows.
#[derive(Clone, Debug, Parser)]
#[command(name = "paper")]
struct Options {
    /// The parts to measure [default: all]
    parts: Vec<Part>,
    /// Prints a line of JSON for each figure, instead of tables
    #[arg(long)]
    json: bool,
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

/// A part of the page.
#[derive(Clone, Copy, Debug, PartialEq, ValueEnum)]
enum Part {
    /// Times of all methods for squares that drift about
    #[value(name = "table1")]
    Table1,
    /// Time per collision of the pairing phase
    #[value(name = "figure3")]
    Figure3,
    /// Squares that converge on the centre
    #[value(name = "figure4")]
    Figure4,
    /// Planar, layered and fully three-dimensional scenes
    ThirdAxis,
    /// Sorting and pairing in parallel
    Threads,
    /// Boxes that move during a frame
    Continuous,
    /// A herd whose animals avoid each other
    Stampede,
    /// Ropes and particles
    Chains,
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
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<()> {
    let pictures = options.pictures.clone();
    let pictures = pictures.unwrap_or_else(|| unisize_charts::scratch_folder("paper"));
    let cannot = || format!("cannot create {}", pictures.display());
    std::fs::create_dir_all(&pictures).with_context(cannot)?;
    let mut run = Run {
        quick: options.quick,
        pictures,
        table: Table::default(),
    };
    let parts = match &options.parts[..] {
        [] => Part::value_variants(),
        parts => parts,
    };
    // Everything runs on one thread, as in the paper, except the part about threads.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    for part in parts {
        eprintln!("{part:?}");
        match part {
            Part::Table1 => pool.install(|| table1::measure(&mut run)),
            Part::Figure3 => pool.install(|| figure3::measure(&mut run)),
            Part::Figure4 => pool.install(|| figure4::measure(&mut run)),
            Part::ThirdAxis => pool.install(|| third_axis::measure(&mut run)),
            Part::Threads => threads::measure(&mut run),
            Part::Continuous => pool.install(|| continuous::measure(&mut run)),
            Part::Stampede => pool.install(|| stampede::measure(&mut run)),
            Part::Chains => pool.install(|| chains::measure(&mut run)),
        }?;
    }
    if !run.quick {
        claims::judge(&mut run.table);
    }
    if options.json {
        run.table.print_json()?;
    } else {
        println!("{}", run.table);
    }
    match &options.page {
        Some(page) => run.table.write_into(page),
        None => Ok(()),
    }
}
