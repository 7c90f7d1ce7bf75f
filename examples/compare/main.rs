//! Does unisize do the same as Rapier's own broad phase, and how much faster does it make a step?
//!
//! ```text
//! cargo run --release --features rapier2d,rapier3d,parallel --example compare
//! ```
//!
//! simulates every scene in two and three dimensions with both broad phases side by side, compares the pairs
//! they hold and the contacts after every step, then times whole steps on each broad phase alone, and prints a table
//! for each dimension.
//! `examples/scenes/src/engine/comparison.rs` lists what is compared. Exits with 1 if anything differs, and
//! with 2 on a usage error.

mod options;
#[path = "../progress/bar.rs"]
mod progress;
mod report;
mod row;
mod spread;
mod table;

use clap::Parser;
use options::Options;
use progress::progress_bar;
use report::Report;
use std::fs::File;
use std::process::ExitCode;

#[path = "."]
mod dim2 {
    use unisize::rapier2d as ours;
    use unisize_scenes::dim2 as scenes;

    const DIM: u8 = 2;

    mod dimension;
    pub(super) use dimension::compare;
}

#[path = "."]
mod dim3 {
    use unisize::rapier3d as ours;
    use unisize_scenes::dim3 as scenes;

    const DIM: u8 = 3;

    mod dimension;
    pub(super) use dimension::compare;
}

fn main() -> ExitCode {
    let options = Options::parse();
    // Opened before the long run, which would be lost if this failed.
    let json = match options.json.as_ref().map(File::create).transpose() {
        Ok(json) => json,
        Err(error) => {
            let path = options.json.as_deref().unwrap_or("".as_ref());
            eprintln!("error: cannot write {}: {error}", path.display());
            return ExitCode::from(2);
        }
    };
    let threads = rayon::ThreadPoolBuilder::new().num_threads(options.threads);
    if let Err(error) = threads.build_global() {
        eprintln!("error: cannot have {} threads: {error}", options.threads);
        return ExitCode::from(2);
    }
    let bar = progress_bar(options.total_steps() as u64);
    let mut report = Report::default();
    for dim in options.dims() {
        table::print_header(&bar, dim);
        for kind in options.scenes() {
            bar.set_message(format!("{} {dim}D", kind.name()));
            let on_step = |_| bar.inc(1);
            let row = match dim {
                2 => dim2::compare(kind, &options, on_step),
                _ => dim3::compare(kind, &options, on_step),
            };
            table::print_row(&bar, &row);
            report.rows.push(row);
        }
        table::print_footer(&bar, report.of_dim(dim));
    }
    bar.finish_and_clear();
    if let Some(json) = json {
        if let Err(error) = serde_json::to_writer_pretty(json, &report) {
            eprintln!("error: cannot write the results: {error}");
            return ExitCode::from(2);
        }
    }
    if report.is_equal() {
        println!("Equal in all {} comparisons.", report.rows.len());
        ExitCode::SUCCESS
    } else {
        println!(
            "{} of {} comparisons found a DIFFERENCE.",
            report.differing(),
            report.rows.len()
        );
        ExitCode::FAILURE
    }
}
