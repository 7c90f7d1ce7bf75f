//! The paper, reproduced: its tables, its figures, its applications and its open questions, beside our own measurements.
//!
//! ```text
//! cargo run --release --features rapier2d,rapier3d,rapier2d_0_36,parallel,baselines --example paper
//! ```
//!
//! remakes every table, chart and picture of `docs/paper.md`, which says what each of them shows: tables are put into the
//! page where their names stand in comments, charts and pictures into `docs/paper/`. One part of it alone is
//!
//! ```text
//! cargo run --release --features rapier2d,rapier3d,rapier2d_0_36,parallel,baselines --example paper -- table1
//! ```
//!
//! All methods get the same boxes in the same frames, in turns, and all must find the same pairs, or the run ends with 1,
//! as it does if it cannot write; with 2 if it was called wrongly.

mod applications;
mod cache;
mod chart;
mod continuous;
mod figure3;
mod figure4;
mod method;
mod options;
mod page;
#[path = "../progress/bar.rs"]
mod progress;
mod published;
mod race;
mod rapier;
mod table;
mod table1;
mod third_axis;
mod threads;

use anyhow::Result;
use clap::Parser;
use options::{Options, Part};
use page::Page;
use std::process::ExitCode;

/// Remakes a part of the page, with few boxes and frames if it is to be quick.
type Remake = fn(&Page, bool) -> Result<()>;

fn main() -> ExitCode {
    let options = Options::parse();
    match run(&options) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: &Options) -> Result<()> {
    if let Part::CacheProbe {
        method,
        count,
        density,
    } = options.part()
    {
        return cache::probe(method, count, density);
    }
    let page = Page::open(&options.out)?;
    let parts: [(Part, Remake); 8] = [
        (Part::Table1, table1::run),
        (Part::Figure3, figure3::run),
        (Part::Figure4, figure4::run),
        (Part::ThirdAxis, third_axis::run),
        (Part::Threads, threads::run),
        (Part::Cache, cache::run),
        (Part::Continuous, continuous::run),
        (Part::Applications, applications::run),
    ];
    // Everything on one thread, as in the paper, but for the part that is about threads.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    for (part, run) in parts {
        if options.part() == part || options.part() == Part::All {
            if part == Part::Threads {
                run(&page, options.quick)?;
            } else {
                pool.install(|| run(&page, options.quick))?;
            }
        }
    }
    Ok(())
}
