//! Does unisize run forever in the same memory?
//!
//! ```text
//! cargo run --release --all-features --example soak
//! ```
//!
//! makes a million updates in two and in three dimensions, in which colliders rest, drift, tremble, jump, come and go,
//! and are disabled, resized and given NaN poses. Exits with 1 if memory grows, and with 2 on a usage error.

mod memory;
mod options;
#[path = "../progress/bar.rs"]
mod progress;

use clap::Parser;
use indicatif::ProgressBar;
use memory::{Peaks, live_bytes};
use options::Options;
use progress::progress_bar;
use std::process::ExitCode;
use std::time::Instant;

#[path = "."]
mod dim2 {
    use rapier2d as rapier;
    use unisize::rapier2d_027::UnisizeBroadPhase;
    use unisize_scenes::dim2::Observed;

    mod soak;
    pub(crate) use soak::Soak;
}

#[path = "."]
mod dim3 {
    use rapier3d as rapier;
    use unisize::rapier3d_027::UnisizeBroadPhase;
    use unisize_scenes::dim3::Observed;

    mod soak;
    pub(crate) use soak::Soak;
}

/// Makes the updates in one dimension, and returns the peaks and the number of pairs held at the end.
macro_rules! soaked {
    ($soak:ty, $options:expr, $bar:expr) => {{
        let (options, bar): (&Options, &ProgressBar) = ($options, $bar);
        let mut soak = <$soak>::new(options.colliders as usize, options.seed);
        let mut peaks = Peaks::default();
        for done in 1..=options.updates {
            soak.update();
            peaks.note(done, options.updates);
            if done % options.check_every == 0 || done == options.updates {
                soak.check();
                bar.set_position(done);
            }
        }
        (peaks, soak.pairs(), live_bytes())
    }};
}

fn main() -> ExitCode {
    let options = Options::parse();
    let mut is_flat = true;
    for &dim in options.dims() {
        let bar = progress_bar(options.updates);
        bar.set_message(format!("{dim}D"));
        let start = Instant::now();
        let (peaks, pairs, end) = match dim {
            2 => soaked!(dim2::Soak, &options, &bar),
            _ => soaked!(dim3::Soak, &options, &bar),
        };
        bar.finish_and_clear();
        println!(
            "{dim}D: {} updates of {} colliders in {:.0} s, {} checks, {pairs} pairs held at the end",
            options.updates,
            options.colliders,
            start.elapsed().as_secs_f64(),
            options.updates.div_ceil(options.check_every),
        );
        println!(
            "    bytes held: {} at most in the first tenth, {} at most later, {end} at the end",
            peaks.early, peaks.late,
        );
        is_flat &= peaks.are_flat();
    }
    if is_flat {
        println!("Memory did not grow.");
        ExitCode::SUCCESS
    } else {
        println!("Memory GREW.");
        ExitCode::FAILURE
    }
}
