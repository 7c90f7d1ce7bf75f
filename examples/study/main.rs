//! Studies of what unisize does to a simulation.
//!
//! ```text
//! cargo run --release --all-features --example study -- stability
//! ```
//!
//! | study | what it answers |
//! |---|---|
//! | `missed` | what do methods miss that trade accuracy for speed, and how much faster are they? |
//! | `accuracy` | what does the time of a simulation buy, and can unisize be told apart from Rapier's own broad phase? |
//! | `stability` | where small worlds fail, does unisize fail alone? |
//! | `soak` | does unisize run forever in the same memory? |
//!
//! All take `--dimension`, `--steps`, `--seeds` and `--quick`, print tables in Markdown, append a line of JSON for each row to
//! `--json FILE`, and draw charts into `--chart FOLDER`. They exit with 1 if unisize does not pass, and with 2 if they were called wrongly
//! or cannot write. What is timed runs on one thread, by the processor time of that thread.

mod accuracy;
mod finder;
#[path = "../../benches/common/json_lines.rs"]
mod json_lines;
mod missed;
mod options;
mod output;
#[path = "../progress/bar.rs"]
mod progress;
#[path = "../../benches/common/report.rs"]
mod report;
mod soak;
mod stability;
mod statistics;

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
    Finder::Seldom(2, None),
    Finder::Grid(Cell::Largest),
    Finder::Grid(Cell::Median),
    Finder::Lossy,
];

/// What runs in Rapier, in one dimension.
macro_rules! engine {
    ($name:ident, $unisize:ident, $flavour:literal) => {
        #[path = "engine"]
        mod $name {
            use unisize::$unisize as ours;
            use unisize_scenes::$name as scenes;

            pub(super) mod accuracy;
            mod finder;
            #[path = $flavour]
            mod flavour;
            mod grid;
            pub(super) mod missed;
            mod seldom;
            pub(super) mod soak;
            mod space;
            pub(super) mod stability;
            #[path = "version/rapier_027.rs"]
            mod version;
        }
    };
}

engine!(dim2, rapier2d_027, "flavour/dim2.rs");
engine!(dim3, rapier3d_027, "flavour/dim3.rs");

/// Studies of what unisize does to a simulation.
#[derive(Debug, Parser)]
#[command(name = "study")]
enum Study {
    Missed(missed::Arguments),
    Accuracy(accuracy::Arguments),
    Stability(stability::Arguments),
    Soak(soak::Arguments),
}

fn main() -> ExitCode {
    output::exit_code(|| match Study::parse() {
        Study::Missed(study) => study.run(),
        Study::Accuracy(study) => study.run(),
        Study::Stability(study) => study.run(),
        Study::Soak(study) => study.run(),
    })
}
