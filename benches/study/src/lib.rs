//! Studies of what unisize does to a simulation.
//!
//! ```text
//! cargo run --release --manifest-path benches/Cargo.toml --package study -- stability
//! ```
//!
//! | study | what it answers |
//! |---|---|
//! | `missed` | what do methods miss that trade accuracy for speed, and how much faster are they? |
//! | `accuracy` | what does the time of a simulation buy, and can unisize be told apart from Rapier's own broad phase? |
//! | `stability` | where small worlds fail, does unisize fail alone? |
//! | `asleep` | does a world fall asleep sooner or later than on Rapier's own broad phase? |
//! | `soak` | does unisize run forever in the same memory? |
//!
//! All take `--dimension`, `--steps`, `--seeds` and `--quick`, print tables in Markdown, and append a line of JSON for each row to
//! `--json FILE`, from which `.ci/chart` draws. They exit with 1 if unisize does not pass, and with 2 if they were called wrongly or
//! cannot write. Times are the processor time of one thread.
//!
//! The feature `rapier-036` builds `accuracy`, `stability` and `asleep` for a patched copy of Rapier 0.36; `benches/patched/study` is
//! that program.

mod accuracy;
mod asleep;
mod finder;
#[cfg(not(feature = "rapier-036"))]
mod missed;
mod options;
mod output;
#[cfg(not(feature = "rapier-036"))]
mod soak;
mod stability;
mod statistics;

use clap::Parser;
use std::process::ExitCode;
use unisize::PairFilter;

/// The version of Rapier.
const RAPIER: &str = if cfg!(feature = "rapier-036") {
    "0.36"
} else {
    "0.27"
};

/// The level that leaves out the same pairs as the default broad phase. With it, and with events in order, runs on both are equal to the
/// bit.
const FILTER_OF_DEFAULT: PairFilter = match cfg!(feature = "rapier-036") {
    true => PairFilter::Groups,
    false => PairFilter::Off,
};

/// The part of the studies that runs in Rapier, in one dimension.
macro_rules! engine {
    ($name:ident, $ours:ident, $scenes:ident) => {
        #[path = "engine"]
        mod $name {
            use unisize::$ours as ours;
            use unisize_scenes::$scenes as scenes;

            pub(super) mod accuracy;
            pub(super) mod asleep;
            mod finder;
            #[cfg(not(feature = "rapier-036"))]
            mod grid;
            #[cfg(not(feature = "rapier-036"))]
            pub(super) mod missed;
            #[cfg(not(feature = "rapier-036"))]
            pub(super) mod soak;
            mod space;
            pub(super) mod stability;
        }
    };
}

#[cfg(not(feature = "rapier-036"))]
engine!(dim2, rapier2d_027, dim2);
#[cfg(not(feature = "rapier-036"))]
engine!(dim3, rapier3d_027, dim3);
#[cfg(feature = "rapier-036")]
engine!(dim2, rapier2d_036, dim2_036);
#[cfg(feature = "rapier-036")]
engine!(dim3, rapier3d_036, dim3_036);

/// Studies of what unisize does to a simulation.
#[derive(Debug, Parser)]
#[command(name = "study")]
enum Study {
    #[cfg(not(feature = "rapier-036"))]
    Missed(missed::Arguments),
    Accuracy(accuracy::Arguments),
    Stability(stability::Arguments),
    Asleep(asleep::Arguments),
    #[cfg(not(feature = "rapier-036"))]
    Soak(soak::Arguments),
}

/// Runs the study that the command line names.
pub fn run() -> ExitCode {
    output::exit_code(|| match Study::parse() {
        #[cfg(not(feature = "rapier-036"))]
        Study::Missed(study) => study.run(),
        Study::Accuracy(study) => study.run(),
        Study::Stability(study) => study.run(),
        Study::Asleep(study) => study.run(),
        #[cfg(not(feature = "rapier-036"))]
        Study::Soak(study) => study.run(),
    })
}
