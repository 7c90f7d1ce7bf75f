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
use options::Common;
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
    /// What do methods miss that trade accuracy for speed, and how much faster are they?
    ///
    /// Exits with 1 if unisize, or another method that cannot miss, misses a pair whose shapes touch or nearly touch.
    #[cfg(not(feature = "rapier-036"))]
    Missed(Common),
    /// How accurate is a simulation for its time, and does unisize differ significantly from Rapier's own broad phase?
    ///
    /// Exits with 1 if simulations on both differ though their events are in the same order, or if the tests do not notice that one pair
    /// in a thousand is lost. With fewer than 15 seeds, and in a quick run, the order of events is the only check.
    Accuracy(Common),
    /// Where small worlds fail, does unisize fail alone?
    ///
    /// Exits with 1 if a world is not the same on both with their events in order, if unisize panics where Rapier's own does not, or if
    /// it fails alone at any value, or more often at all of them.
    Stability(Common),
    /// Does a world fall asleep sooner or later than on Rapier's own broad phase?
    ///
    /// The times are in simulated seconds. A world that is still awake at the end counts with the whole time. Exits with 1 if no world
    /// falls asleep at all, as there is nothing to compare then.
    Asleep(Common),
    /// Does unisize run forever in the same memory?
    ///
    /// Exits with 1 if memory later peaks at more than one and a half times its peak in the first tenth of the updates.
    #[cfg(not(feature = "rapier-036"))]
    Soak(Common),
}

/// Runs the study that the command line names.
pub fn run() -> ExitCode {
    output::exit_code(|| match Study::parse() {
        #[cfg(not(feature = "rapier-036"))]
        Study::Missed(common) => missed::run(&common),
        Study::Accuracy(common) => accuracy::run(&common),
        Study::Stability(common) => stability::run(&common),
        Study::Asleep(common) => asleep::run(&common),
        #[cfg(not(feature = "rapier-036"))]
        Study::Soak(common) => soak::run(&common),
    })
}
