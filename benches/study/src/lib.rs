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
//! | `soak` | does unisize run forever in the same memory? |
//!
//! All take `--dimension`, `--steps`, `--seeds` and `--quick`, print tables in Markdown, and append a line of JSON for each row to
//! `--json FILE`, from which `.ci/chart` draws. They exit with 1 if unisize does not pass, and with 2 if they were called wrongly or
//! cannot write. What is timed runs on one thread, by the processor time of that thread.
//!
//! With the feature `rapier-036` they are of Rapier 0.36, on a patched copy, and there are `accuracy` and `stability`:
//! `benches/patched/study` is that program.

mod accuracy;
#[cfg_attr(feature = "rapier-036", allow(dead_code))] // Some methods are of the study of frames.
mod finder;
#[cfg(not(feature = "rapier-036"))]
mod missed;
mod options;
mod output;
#[cfg(not(feature = "rapier-036"))]
mod soak;
mod stability;
mod statistics;
#[cfg_attr(feature = "rapier-036", path = "version/rapier_036.rs")]
#[cfg_attr(not(feature = "rapier-036"), path = "version/rapier_027.rs")]
mod version;

use clap::Parser;
use std::process::ExitCode;

/// What runs in Rapier, in one dimension.
macro_rules! engine {
    ($name:ident, $flavour:literal) => {
        #[path = "engine"]
        mod $name {
            use super::version::$name::{ours, scenes};

            pub(super) mod accuracy;
            mod finder;
            #[path = $flavour]
            mod flavour;
            #[cfg(not(feature = "rapier-036"))]
            mod grid;
            #[cfg(not(feature = "rapier-036"))]
            pub(super) mod missed;
            mod seldom;
            #[cfg(not(feature = "rapier-036"))]
            pub(super) mod soak;
            mod space;
            pub(super) mod stability;
            #[cfg_attr(feature = "rapier-036", path = "version/rapier_036.rs")]
            #[cfg_attr(not(feature = "rapier-036"), path = "version/rapier_027.rs")]
            mod version;
        }
    };
}

engine!(dim2, "flavour/dim2.rs");
engine!(dim3, "flavour/dim3.rs");

/// Studies of what unisize does to a simulation.
#[derive(Debug, Parser)]
#[command(name = "study")]
enum Study {
    #[cfg(not(feature = "rapier-036"))]
    Missed(missed::Arguments),
    Accuracy(accuracy::Arguments),
    Stability(stability::Arguments),
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
        #[cfg(not(feature = "rapier-036"))]
        Study::Soak(study) => study.run(),
    })
}
