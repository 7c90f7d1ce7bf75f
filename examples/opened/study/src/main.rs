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
#[path = "../../../study/statistics/mod.rs"]
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

#[path = "../../../study/engine"]
mod dim2 {
    //! What runs in rapier2d.
    use unisize::rapier2d_036 as ours;
    use unisize_scenes::dim2_036 as scenes;

    pub(super) mod accuracy;
    mod finder;
    #[path = "flavour/dim2.rs"]
    mod flavour;
    mod seldom;
    mod space;
    pub(super) mod stability;
    #[path = "version/rapier_036.rs"]
    mod version;
}

#[path = "../../../study/engine"]
mod dim3 {
    //! What runs in rapier3d.
    use unisize::rapier3d_036 as ours;
    use unisize_scenes::dim3_036 as scenes;

    pub(super) mod accuracy;
    mod finder;
    #[path = "flavour/dim3.rs"]
    mod flavour;
    mod seldom;
    mod space;
    pub(super) mod stability;
    #[path = "version/rapier_036.rs"]
    mod version;
}

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
