//! The paper, reproduced: its tables, its figures, its applications and its open questions, beside our own measurements.
//!
//! ```text
//! cargo run --release --features rapier2d-027,rapier3d-027,rapier2d-036,parallel --example paper
//! ```
//!
//! remakes every table, chart and picture of `docs/paper.md`, which explains them. Tables go into the page between comments
//! with their names, charts and pictures into `docs/paper/`. To remake one part:
//!
//! ```text
//! cargo run --release --features rapier2d-027,rapier3d-027,rapier2d-036,parallel --example paper -- table1
//! ```
//!
//! All methods get the same boxes in the same frames, in turns. The program exits with 1 if they find different pairs or if it
//! cannot write, and with 2 if it was called wrongly.

mod applications;
mod cache;
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

/// Remakes a part of the page; the flag asks for few boxes and frames.
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
    let page = Page::open(&options.out())?;
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
    // Everything runs on one thread, as in the paper, except the part about threads.
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
