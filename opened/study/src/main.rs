//! Studies of what unisize does to a simulation in Rapier 0.36.
//!
//! ```text
//! cargo run --release --package study-opened -- stability
//! ```
//!
//! The same program as `examples/study`, which says what is studied, on an opened copy of Rapier.

#[path = "../../../examples/study/accuracy/mod.rs"]
mod accuracy;
#[allow(dead_code)] // Without the studies of frames, and without grids, some of it is not used.
#[path = "../../../examples/study/finder.rs"]
mod finder;
#[path = "../../../examples/study/options.rs"]
mod options;
#[path = "../../../examples/study/output.rs"]
mod output;
#[path = "../../../examples/progress/bar.rs"]
mod progress;
#[path = "../../../examples/study/stability/mod.rs"]
mod stability;
#[path = "../../../examples/study/statistics/mod.rs"]
mod statistics;

use accuracy::case::{Case, Run, Scalar};
use anyhow::{Context, Result};
use clap::Parser;
use finder::Finder;
use std::process::ExitCode;

/// The version of Rapier.
const RAPIER: &str = "0.36";

/// The level that leaves out what the default broad phase leaves out: with it, and with events in order, both do the same to the bit.
const FILTER_OF_DEFAULT: unisize::PairFilter = unisize::PairFilter::Groups;

/// What `accuracy` simulates with.
const FINDERS: &[Finder] = &[
    Finder::Rapier,
    Finder::DEFAULT,
    Finder::Seldom(2),
    Finder::Lossy,
];

/// The numbers that there is Rapier for.
const SCALARS: &[Scalar] = &[Scalar::F32, Scalar::F64];

#[path = "../../../examples/study/engine"]
mod dim2 {
    //! What runs in rapier2d.
    use unisize::rapier2d_036 as ours;
    use unisize_scenes::dim2_036 as scenes;

    pub(super) mod accuracy;
    mod approximate;
    #[path = "flavour/dim2.rs"]
    mod flavour;
    mod space;
    pub(super) mod stability;
    #[path = "version/rapier_036.rs"]
    mod version;
}

#[path = "../../../examples/study/engine"]
mod dim3 {
    //! What runs in rapier3d.
    use unisize::rapier3d_036 as ours;
    use unisize_scenes::dim3_036 as scenes;

    pub(super) mod accuracy;
    mod approximate;
    #[path = "flavour/dim3.rs"]
    mod flavour;
    mod space;
    pub(super) mod stability;
    #[path = "version/rapier_036.rs"]
    mod version;
}

#[path = "../../../examples/study/engine"]
mod dim2_f64 {
    //! What runs in rapier2d-f64.
    use unisize::rapier2d_f64_036 as ours;
    use unisize_scenes::dim2_f64_036 as scenes;

    pub(super) mod accuracy;
    mod approximate;
    #[allow(dead_code)] // Worlds at their limits are simulated in `f32` alone.
    #[path = "flavour/dim2.rs"]
    mod flavour;
    #[allow(dead_code)]
    mod space;
    #[allow(dead_code)]
    #[path = "version/rapier_036.rs"]
    mod version;
}

#[path = "../../../examples/study/engine"]
mod dim3_f64 {
    //! What runs in rapier3d-f64.
    use unisize::rapier3d_f64_036 as ours;
    use unisize_scenes::dim3_f64_036 as scenes;

    pub(super) mod accuracy;
    mod approximate;
    #[allow(dead_code)] // Worlds at their limits are simulated in `f32` alone.
    #[path = "flavour/dim3.rs"]
    mod flavour;
    #[allow(dead_code)]
    mod space;
    #[allow(dead_code)]
    #[path = "version/rapier_036.rs"]
    mod version;
}

/// Simulates a case in one flavour of Rapier.
fn simulate(dim: u8, scalar: Scalar, case: &Case) -> Run {
    match (dim, scalar) {
        (2, Scalar::F32) => dim2::accuracy::run(case),
        (_, Scalar::F32) => dim3::accuracy::run(case),
        (2, Scalar::F64) => dim2_f64::accuracy::run(case),
        (_, Scalar::F64) => dim3_f64::accuracy::run(case),
    }
}

/// Studies of what unisize does to a simulation.
#[derive(Debug, Parser)]
#[command(name = "study")]
enum Study {
    Accuracy(accuracy::Arguments),
    Stability(stability::Arguments),
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
        Study::Accuracy(study) => study.run(),
        Study::Stability(study) => study.run(),
    }
}
