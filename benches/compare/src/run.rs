//! The whole run: every scene in each dimension, the tables, and the exit code.

use crate::options::Options;
use crate::{dim2, dim3, table};
use clap::Parser;
use std::error::Error;
use std::process::ExitCode;
use unisize_report::{JsonLines, Table, progress_bar};

/// Compares as the command line says.
pub fn run() -> ExitCode {
    match compare_all(&Options::parse()) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(_) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

/// Returns how many comparisons found a difference.
fn compare_all(options: &Options) -> Result<usize, Box<dyn Error>> {
    // Opened before the long run, which would be lost if this failed.
    let mut json = JsonLines::append(options.json.as_deref())?;
    let threads = rayon::ThreadPoolBuilder::new().num_threads(options.threads);
    threads.build_global()?;
    let count = options.dims().count() * options.cases().count();
    let bar = progress_bar(count as u64);
    let mut differing = 0;
    for dim in options.dims() {
        let mut rows = Vec::new();
        let mut table = Table::default();
        bar.suspend(|| println!("\nrapier{dim}d {}", crate::RAPIER));
        for case in options.cases() {
            bar.set_message(format!("{} {dim}D", case.name()));
            let row = match dim {
                2 => dim2::compare(case, options),
                _ => dim3::compare(case, options),
            };
            bar.inc(1);
            bar.suspend(|| table.row(&table::cells(&row)));
            json.write(&row)?;
            differing += usize::from(!row.equal);
            rows.push(row);
        }
        bar.suspend(|| println!("{}", table::footer(&rows)));
    }
    bar.finish_and_clear();
    match differing {
        0 => println!("Equal in all {count} comparisons."),
        _ => println!("{differing} of {count} comparisons found a DIFFERENCE."),
    }
    Ok(differing)
}
