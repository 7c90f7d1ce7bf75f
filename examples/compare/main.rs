//! Does unisize do the same as Rapier's own broad phase, and how much faster does it make a step?
//!
//! ```text
//! cargo run --release --features rapier2d-027,rapier3d-027,parallel --example compare
//! ```
//!
//! simulates every scene in two and three dimensions with both broad phases side by side, compares the pairs
//! they hold and the contacts after every step, then times whole steps on each broad phase alone, and prints a table
//! for each dimension.
//! `examples/scenes/src/engine/comparison.rs` lists what is compared. Exits with 1 if anything differs, and
//! with 2 on a usage error.

mod case;
mod forecast;
#[path = "../../benches/common/json_lines.rs"]
mod json_lines;
mod options;
#[path = "../progress/bar.rs"]
mod progress;
mod row;
mod run;
mod table;

use std::process::ExitCode;

/// The version of Rapier.
const RAPIER: &str = "0.27";

/// The default of `--filter`, as the library has it.
const FILTER: &str = "off";

/// The level that leaves out what the default broad phase leaves out.
const FILTER_OF_DEFAULT: unisize::PairFilter = unisize::PairFilter::Off;

#[path = "."]
mod dim2 {
    use unisize::rapier2d_027 as ours;
    use unisize_scenes::dim2 as scenes;

    const DIM: u8 = 2;

    mod dimension;
    pub(super) use dimension::compare;
}

#[path = "."]
mod dim3 {
    use unisize::rapier3d_027 as ours;
    use unisize_scenes::dim3 as scenes;

    const DIM: u8 = 3;

    mod dimension;
    pub(super) use dimension::compare;
}

fn main() -> ExitCode {
    run::run()
}
