//! What does each setting cost, and what is it worth?
//!
//! ```text
//! cargo run --release --all-features --example tradeoff
//! ```
//!
//! takes Rapier's own broad phase and unisize with each kernel and a range of margins through six scenes in two and
//! three dimensions. All get the same scene at the same step, in turns, and three things are measured:
//!
//! - **recall**: of the pairs of colliders whose shapes touch, as Parry's exact queries have it, how many are held;
//! - **cost**: the time of the broad phase, and that of the broad and the narrow phase together, for a wide margin only
//!   moves work from one to the other;
//! - **fidelity**: how a whole simulation on each of them fares, against one with a quarter of the time step.
//!
//! Prints tables in Markdown, draws `docs/figures/tradeoff-*.svg`, and ends with 1 if a touching pair was missed or the
//! default settings do not simulate what Rapier's broad phase does, and with 2 if it was called wrongly or cannot write.

mod chart;
mod course;
mod dim2;
mod dim3;
mod method;
mod options;
#[path = "../progress/bar.rs"]
mod progress;
mod study;
mod table;

use clap::Parser;
use options::Options;
use progress::progress_bar;
use std::process::ExitCode;

fn main() -> ExitCode {
    let options = Options::parse();
    let figures = options.out.join("docs/figures");
    // Before the long run, which would be lost if this failed.
    if let Err(error) = std::fs::create_dir_all(&figures) {
        eprintln!("error: cannot create {}: {error}", figures.display());
        return ExitCode::from(2);
    }
    let bar = progress_bar(options.total_steps() as u64);
    let mut studies = Vec::new();
    for kind in options.scenes() {
        for dim in [2, 3] {
            bar.set_message(format!("{} {dim}D", kind.name()));
            let study = match dim {
                2 => dim2::study(kind, &options, || bar.inc(1)),
                _ => dim3::study(kind, &options, || bar.inc(1)),
            };
            bar.suspend(|| table::print_study(&study));
            studies.push(study);
        }
    }
    bar.finish_and_clear();
    table::print_summary(&studies);
    for dim in [2, 3] {
        let of_dim: Vec<_> = studies.iter().filter(|study| study.dim == dim).collect();
        let file = figures.join(format!("tradeoff-{dim}d.svg"));
        if let Err(error) = chart::draw(&file, dim, &of_dim) {
            eprintln!("error: cannot draw {}: {error}", file.display());
            return ExitCode::from(2);
        }
        println!("Drawn: {}", file.display());
    }
    let missed: usize = studies.iter().map(study::Study::missed).sum();
    if missed == 0 {
        println!("No method missed a pair that touches.");
    } else {
        println!("MISSED: {missed} pairs that touch.");
    }
    let differing = studies.iter().filter(|study| !study.is_same_in_order());
    let differing = differing.count();
    if differing == 0 {
        println!(
            "With events in order, all simulations on the default settings were those on Rapier's."
        );
    } else {
        println!(
            "DIFFERENT from Rapier's, although events were in order: {differing} simulations."
        );
    }
    match missed + differing {
        0 => ExitCode::SUCCESS,
        _ => ExitCode::FAILURE,
    }
}
