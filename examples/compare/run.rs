//! The whole run: every scene in each dimension, the tables, and the exit code.

use crate::json_lines::JsonLines;
use crate::options::Options;
use crate::progress::progress_bar;
use crate::report::Report;
use crate::{dim2, dim3, table};
use clap::Parser;
use std::process::ExitCode;

/// Compares as the command line says.
pub(super) fn run() -> ExitCode {
    let options = Options::parse();
    // Opened before the long run, which would be lost if this failed.
    let mut json = match JsonLines::append(options.json.as_deref()) {
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
        for case in options.cases() {
            bar.set_message(format!("{} {dim}D", case.name()));
            let on_step = |_| bar.inc(1);
            let row = match dim {
                2 => dim2::compare(case, &options, on_step),
                _ => dim3::compare(case, &options, on_step),
            };
            table::print_row(&bar, &row);
            if let Err(error) = json.write(&row) {
                eprintln!("error: cannot write the results: {error}");
                return ExitCode::from(2);
            }
            report.rows.push(row);
        }
        table::print_footer(&bar, report.of_dim(dim));
    }
    bar.finish_and_clear();
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
