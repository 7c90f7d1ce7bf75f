//! Studies of what unisize does to a simulation.
//!
//! ```text
//! cargo run --release --all-features --example study -- stability
//! ```
//!
//! | study | what it answers |
//! |---|---|
//! | `settings` | what does each kernel, margin and filter of unisize cost? |
//! | `missed` | what do methods miss that trade accuracy for speed, and how much faster are they? |
//! | `accuracy` | what does the time of a simulation buy, and can unisize be told apart from Rapier's own broad phase? |
//! | `stability` | where small worlds fail, does unisize fail alone? |
//! | `soak` | does unisize run forever in the same memory? |
//!
//! All take `--dimension`, `--steps`, `--seeds` and `--quick`, print tables in Markdown, and write a line of JSON for each row to
//! `--json FILE` and charts into `--chart FOLDER`. They exit with 1 if unisize does not pass, and with 2 if they were called wrongly
//! or cannot write. What is timed runs on one thread, by the processor time of that thread.

mod accuracy;
mod finder;
mod frames;
mod options;
mod output;
#[path = "../progress/bar.rs"]
mod progress;
mod soak;
mod stability;
mod statistics;

use accuracy::case::{Case, Run, Scalar};
use anyhow::{Context, Result};
use clap::Parser;
use finder::{Cell, Finder};
use std::process::ExitCode;

/// The version of Rapier.
const RAPIER: &str = "0.27";

/// The level that leaves out what the default broad phase leaves out: with it, and with events in order, both do the same to the bit.
const FILTER_OF_DEFAULT: unisize::PairFilter = unisize::PairFilter::Off;

/// What `accuracy` simulates with.
const FINDERS: &[Finder] = &[
    Finder::Rapier,
    Finder::DEFAULT,
    Finder::Seldom(2),
    Finder::Grid(Cell::Largest),
    Finder::Grid(Cell::Median),
    Finder::Lossy,
];

/// The numbers that there is Rapier for.
#[cfg(all(feature = "rapier2d-f64-027", feature = "rapier3d-f64-027"))]
const SCALARS: &[Scalar] = &[Scalar::F32, Scalar::F64];
#[cfg(not(all(feature = "rapier2d-f64-027", feature = "rapier3d-f64-027")))]
const SCALARS: &[Scalar] = &[Scalar::F32];

#[path = "engine"]
mod dim2 {
    //! What runs in rapier2d.
    use unisize::rapier2d_027 as ours;
    use unisize_scenes::dim2 as scenes;

    pub(super) mod accuracy;
    mod approximate;
    #[path = "flavour/dim2.rs"]
    mod flavour;
    pub(super) mod frames;
    mod grid;
    pub(super) mod soak;
    mod space;
    pub(super) mod stability;
    #[path = "version/rapier_027.rs"]
    mod version;
}

#[path = "engine"]
mod dim3 {
    //! What runs in rapier3d.
    use unisize::rapier3d_027 as ours;
    use unisize_scenes::dim3 as scenes;

    pub(super) mod accuracy;
    mod approximate;
    #[path = "flavour/dim3.rs"]
    mod flavour;
    pub(super) mod frames;
    mod grid;
    pub(super) mod soak;
    mod space;
    pub(super) mod stability;
    #[path = "version/rapier_027.rs"]
    mod version;
}

#[cfg(all(feature = "rapier2d-f64-027", feature = "rapier3d-f64-027"))]
#[path = "engine"]
mod dim2_f64 {
    //! What runs in rapier2d-f64.
    use unisize::rapier2d_f64_027 as ours;
    use unisize_scenes::dim2_f64 as scenes;

    pub(super) mod accuracy;
    mod approximate;
    #[allow(dead_code)] // Worlds at their limits are simulated in `f32` alone.
    #[path = "flavour/dim2.rs"]
    mod flavour;
    mod grid;
    #[allow(dead_code)]
    mod space;
    #[allow(dead_code)]
    #[path = "version/rapier_027.rs"]
    mod version;
}

#[cfg(all(feature = "rapier2d-f64-027", feature = "rapier3d-f64-027"))]
#[path = "engine"]
mod dim3_f64 {
    //! What runs in rapier3d-f64.
    use unisize::rapier3d_f64_027 as ours;
    use unisize_scenes::dim3_f64 as scenes;

    pub(super) mod accuracy;
    mod approximate;
    #[allow(dead_code)] // Worlds at their limits are simulated in `f32` alone.
    #[path = "flavour/dim3.rs"]
    mod flavour;
    mod grid;
    #[allow(dead_code)]
    mod space;
    #[allow(dead_code)]
    #[path = "version/rapier_027.rs"]
    mod version;
}

/// Simulates a case in one flavour of Rapier.
fn simulate(dim: u8, scalar: Scalar, case: &Case) -> Run {
    match (dim, scalar) {
        (2, Scalar::F32) => dim2::accuracy::run(case),
        (_, Scalar::F32) => dim3::accuracy::run(case),
        #[cfg(all(feature = "rapier2d-f64-027", feature = "rapier3d-f64-027"))]
        (2, Scalar::F64) => dim2_f64::accuracy::run(case),
        #[cfg(all(feature = "rapier2d-f64-027", feature = "rapier3d-f64-027"))]
        (_, Scalar::F64) => dim3_f64::accuracy::run(case),
        #[cfg(not(all(feature = "rapier2d-f64-027", feature = "rapier3d-f64-027")))]
        (_, Scalar::F64) => unreachable!("there is no such number in SCALARS"),
    }
}

/// Studies of what unisize does to a simulation.
#[derive(Debug, Parser)]
#[command(name = "study")]
enum Study {
    Settings(frames::settings::Arguments),
    Missed(frames::missed::Arguments),
    Accuracy(accuracy::Arguments),
    Stability(stability::Arguments),
    Soak(soak::Arguments),
}

fn main() -> ExitCode {
    match run(&Study::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::from(2)
        }
    }
}

fn run(study: &Study) -> Result<bool> {
    // The processor time of a thread stands still while a pool of others works for it.
    let threads = rayon::ThreadPoolBuilder::new().num_threads(1);
    threads.build_global().context("cannot have one thread")?;
    match study {
        Study::Settings(study) => study.run(),
        Study::Missed(study) => study.run(),
        Study::Accuracy(study) => study.run(),
        Study::Stability(study) => study.run(),
        Study::Soak(study) => study.run(),
    }
}
