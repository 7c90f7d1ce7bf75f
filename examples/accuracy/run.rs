//! The whole run: every scene in each dimension, the tables, the charts, and the exit code.

use crate::case::{Case, Finder, Method, Scalar};
use crate::options::Options;
use crate::progress::progress_bar;
use crate::study::Study;
use crate::verdict::Verdict;
use crate::{RAPIER, SCALARS, SUFFIX, chart, simulate, table};
use clap::Parser;
use indicatif::ProgressBar;
use std::process::ExitCode;

/// Steps per simulated second: the time steps of every curve.
const FREQUENCIES: &[u32] = &[30, 60, 120, 240];

/// With fewer seeds nothing is said. With n seeds no p-value is less than 2 / 2<sup>n</sup>: with 11 seeds and some sixty tests, the
/// correction makes more than 0.05 of it. With a few more, only that all seeds agree would be seen.
const FEWEST_SEEDS: usize = 15;

/// Measures as the command line says.
pub(super) fn run() -> ExitCode {
    let options = Options::parse();
    // The clock is that of this thread, which stands still while others work for it.
    let threads = rayon::ThreadPoolBuilder::new().num_threads(1);
    if let Err(error) = threads.build_global() {
        eprintln!("error: cannot have a single thread: {error}");
        return ExitCode::from(2);
    }
    let figures = options.out();
    // Before the long run, which a failure would waste.
    if let Err(error) = std::fs::create_dir_all(&figures) {
        eprintln!("error: cannot create {}: {error}", figures.display());
        return ExitCode::from(2);
    }
    let methods = Method::all(SCALARS);
    let runs = methods.len() * FREQUENCIES.len() * options.seeds().len();
    let bar = progress_bar((runs * options.scenes().len() * options.dims().len()) as u64);
    println!("# Rapier {RAPIER}: errors, and the computing time for one simulated second");
    let mut studies = Vec::new();
    for &dim in options.dims() {
        for scene in options.scenes() {
            bar.set_message(format!("{} {dim}D", scene.group()));
            let mut study = Study::new(
                dim,
                scene,
                options.bodies(scene),
                options.seconds(scene),
                &methods,
                FREQUENCIES,
            );
            measure(&mut study, &options.seeds(), &bar);
            bar.suspend(|| table::print_study(&study, options.seeds().len()));
            studies.push(study);
        }
    }
    bar.finish_and_clear();
    let verdict = Verdict::of(&studies);
    table::print_verdict(&verdict);
    table::print_summary(&verdict, &studies);
    for &dim in options.dims() {
        let of_dim: Vec<_> = studies.iter().filter(|study| study.dim == dim).collect();
        let file = figures.join(format!("accuracy-{dim}d{SUFFIX}.svg"));
        if let Err(error) = chart::draw(&file, dim, &of_dim, options.seeds().len()) {
            eprintln!("error: {error}");
            return ExitCode::from(2);
        }
        println!("\nDrawn: {}", file.display());
    }
    let is_finite = studies.iter().all(Study::is_finite);
    if !is_finite {
        println!("\nNOT FINITE: a simulation exploded.");
    }
    let seeds = options.seeds().len();
    if options.quick || seeds < FEWEST_SEEDS {
        match seeds < FEWEST_SEEDS {
            true => println!(
                "\nNo verdict: {seeds} seeds are too few to tell anything apart, which takes {FEWEST_SEEDS}."
            ),
            false => println!("\nA quick run gives no verdict."),
        }
        return if is_finite {
            ExitCode::SUCCESS
        } else {
            ExitCode::FAILURE
        };
    }
    table::print_conclusion(&verdict, studies.len());
    let is_explained = is_by_order_alone(&verdict, &studies, &options.seeds());
    match is_finite && is_explained && !verdict.noticed().is_empty() {
        true => ExitCode::SUCCESS,
        false => ExitCode::FAILURE,
    }
}

/// Whether everything that was told apart is the same, bit for bit, once both broad phases report their events in the same order:
/// then they find the same pairs, and only the order in which the solver goes through them differs.
fn is_by_order_alone(verdict: &Verdict, studies: &[Study], seeds: &[u64]) -> bool {
    let mut is_explained = true;
    for study in studies {
        for &scalar in SCALARS {
            if !verdict.is_told_apart(study.dim, study.scene, scalar) {
                continue;
            }
            let is_same = is_same_in_order(study, scalar, seeds);
            table::print_order(study, scalar, is_same);
            is_explained &= is_same;
        }
    }
    is_explained
}

/// Whether all runs of a scene are the same, bit for bit, with the events of each update sorted: all errors, and all bodies at the
/// end.
fn is_same_in_order(study: &Study, scalar: Scalar, seeds: &[u64]) -> bool {
    let is_same = |seed: u64, frequency: u32| {
        let [own, ours] = [Finder::Rapier, Finder::Unisize].map(|finder| {
            let case = Case {
                scene: study.scene,
                finder,
                is_sorted: true,
                frequency,
                seed,
                bodies: study.bodies,
                seconds: study.seconds,
            };
            let run = simulate(study.dim, scalar, &case);
            (run.state, run.errors)
        });
        own == ours
    };
    let mut frequencies = study.frequencies.iter();
    frequencies.all(|&frequency| seeds.iter().all(|&seed| is_same(seed, frequency)))
}

/// Simulates a scene with every method, time step and seed. Methods go in turns, and another one begins with every seed, so that
/// none has the machine at a better time than the others.
fn measure(study: &mut Study, seeds: &[u64], bar: &ProgressBar) {
    let mut methods = study.methods.clone();
    for &seed in seeds {
        for &frequency in study.frequencies {
            for &method in &methods {
                let case = Case {
                    scene: study.scene,
                    finder: method.finder,
                    is_sorted: false,
                    frequency,
                    seed,
                    bodies: study.bodies,
                    seconds: study.seconds,
                };
                study.push(method, frequency, simulate(study.dim, method.scalar, &case));
                bar.inc(1);
            }
        }
        methods.rotate_left(1);
    }
}
