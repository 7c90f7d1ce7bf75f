//! The whole run: all cases, the shifts, the tables and charts, and the exit code.

use crate::discordance::Discordance;
use crate::options::Options;
use crate::progress::progress_bar;
use crate::row::Row;
use crate::shift::{Scenery, Shift};
use crate::{chart, dim2, dim3, table};
use clap::Parser;
use std::process::ExitCode;

/// How often a world is shifted.
const SHIFTS: usize = 8;

/// Runs what the command line asks for.
pub(super) fn run() -> ExitCode {
    // The processor time of a thread stands still while a pool of others works for it.
    let threads = rayon::ThreadPoolBuilder::new().num_threads(1);
    if let Err(error) = threads.build_global() {
        eprintln!("error: cannot have one thread: {error}");
        return ExitCode::from(2);
    }
    let options = Options::parse();
    let figures = options.out();
    // Before the long run, which a failure would waste.
    if let Err(error) = std::fs::create_dir_all(&figures) {
        eprintln!("error: cannot create {}: {error}", figures.display());
        return ExitCode::from(2);
    }
    let cases = options.total_cases() * options.dims().len();
    let bar = progress_bar((cases * options.runs()) as u64);
    let mut rows = Vec::new();
    for &dim in options.dims() {
        for family in options.families() {
            bar.set_message(format!("{} {dim}D", family.name()));
            let first = rows.len();
            for case in options.cases(family) {
                let on_run = || bar.inc(1);
                rows.push(match dim {
                    2 => dim2::study(&case, &options, on_run),
                    _ => dim3::study(&case, &options, on_run),
                });
            }
            bar.suspend(|| table::print_family(family, &rows[first..], cases));
        }
    }
    bar.finish_and_clear();
    let shifts = shifts(&options);
    let discordance = Discordance::of(&rows);
    table::print_summary(&rows, cases, discordance);
    for &dim in options.dims() {
        let of_dim: Vec<_> = rows.iter().filter(|row| row.dim == dim).collect();
        if of_dim.is_empty() {
            continue;
        }
        let file = figures.join(format!("stress-{dim}d.svg"));
        if let Err(error) = chart::draw(&file, dim, &of_dim) {
            eprintln!("error: {error}");
            return ExitCode::from(2);
        }
        println!("Drawn: {}", file.display());
    }
    exit_code(&rows, cases, discordance, &shifts)
}

fn shifts(options: &Options) -> Vec<Shift> {
    let mut shifts = Vec::new();
    if !options.has_shifts() {
        return shifts;
    }
    for &dim in options.dims() {
        let of_dim = Scenery::ALL.map(|scenery| match dim {
            2 => dim2::shift(scenery, options, SHIFTS),
            _ => dim3::shift(scenery, options, SHIFTS),
        });
        table::print_shifts(dim, &of_dim);
        shifts.extend(of_dim);
    }
    shifts
}

fn exit_code(rows: &[Row], cases: usize, discordance: Discordance, shifts: &[Shift]) -> ExitCode {
    let unsound = rows.iter().filter(|row| !row.is_sound(cases)).count();
    let differing = shifts.iter().filter(|shift| !shift.is_sound());
    let differing = differing.count();
    if unsound + differing == 0 && !discordance.is_worse() {
        println!(
            "unisize fails alone in none of {} cases and not more often in all of them, and did what Rapier's own did wherever both were compared.",
            rows.len()
        );
        ExitCode::SUCCESS
    } else {
        let more_often = match discordance.is_worse() {
            true => ", and unisize fails more often in all cases together",
            false => "",
        };
        println!("WRONG: {unsound} cases and {differing} shifts{more_often}.");
        ExitCode::FAILURE
    }
}
