//! Studies of what unisize does to a simulation in Rapier 0.36.
//!
//! ```text
//! cargo run --release --package study-opened -- stability
//! ```
//!
//! The same program as `examples/study`, which says what is studied, on an opened copy of Rapier.

#[path = "../../../study/accuracy/mod.rs"]
mod accuracy;
#[allow(dead_code)] // Some methods are of the study of frames, and a step on a grid finds no tree to ask.
#[path = "../../../study/finder.rs"]
mod finder;
#[path = "../../../../benches/common/json_lines.rs"]
mod json_lines;
#[path = "../../../study/options.rs"]
mod options;
#[path = "../../../study/output.rs"]
mod output;
#[path = "../../../progress/bar.rs"]
mod progress;
#[path = "../../../../benches/common/report.rs"]
mod report;
#[path = "../../../study/stability/mod.rs"]
mod stability;
#[path = "../../../study/statistics.rs"]
mod statistics;

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
    Finder::Seldom(2, None),
    Finder::Lossy,
];

/// What runs in Rapier, in one dimension.
macro_rules! engine {
    ($name:ident, $unisize:ident, $scenes:ident, $flavour:literal) => {
        #[path = "../../../study/engine"]
        mod $name {
            use unisize::$unisize as ours;
            use unisize_scenes::$scenes as scenes;

            pub(super) mod accuracy;
            mod finder;
            #[path = $flavour]
            mod flavour;
            mod seldom;
            mod space;
            pub(super) mod stability;
            #[path = "version/rapier_036.rs"]
            mod version;
        }
    };
}

engine!(dim2, rapier2d_036, dim2_036, "flavour/dim2.rs");
engine!(dim3, rapier3d_036, dim3_036, "flavour/dim3.rs");

/// Studies of what unisize does to a simulation.
#[derive(Debug, Parser)]
#[command(name = "study")]
enum Study {
    Accuracy(accuracy::Arguments),
    Stability(stability::Arguments),
}

fn main() -> ExitCode {
    output::exit_code(|| match Study::parse() {
        Study::Accuracy(study) => study.run(),
        Study::Stability(study) => study.run(),
    })
}
