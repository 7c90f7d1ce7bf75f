//! Does unisize do the same as Rapier 0.36's own broad phase in its own pipelines, and how much faster does it make a step?
//!
//! ```text
//! cargo run --release --package compare-opened -- --quick
//! ```
//!
//! The same program as `examples/compare`, which says what is compared, on an opened copy of Rapier. The broad phase is timed
//! where the copy calls it, in `update` and in `set_aabbs`, alike for both. Rapier's own optimizes its tree between the two,
//! beside the solver if it has threads; there it is timed as a part of the next update. Whole steps are Rapier as it is.
//!
//! With the feature `parallel`, Rapier and unisize share the threads that `--threads` asks for.

#[path = "../../../compare/case.rs"]
mod case;
#[path = "../../../compare/forecast.rs"]
mod forecast;
#[path = "../../../../benches/common/json_lines.rs"]
mod json_lines;
#[path = "../../../compare/options.rs"]
mod options;
#[path = "../../../progress/bar.rs"]
mod progress;
#[path = "../../../compare/row.rs"]
mod row;
#[path = "../../../compare/run.rs"]
mod run;
#[path = "../../../compare/table.rs"]
mod table;

use std::process::ExitCode;

/// The version of Rapier.
const RAPIER: &str = "0.36";

/// The default of `--filter`, as the library has it.
const FILTER: &str = "shapes";

/// The level that leaves out what the default broad phase leaves out.
const FILTER_OF_DEFAULT: unisize::PairFilter = unisize::PairFilter::Groups;

#[path = "../../../compare"]
mod dim2 {
    use unisize::rapier2d_036 as ours;
    use unisize_scenes::dim2_036 as scenes;

    const DIM: u8 = 2;

    mod dimension;
    pub(super) use dimension::compare;
}

#[path = "../../../compare"]
mod dim3 {
    use unisize::rapier3d_036 as ours;
    use unisize_scenes::dim3_036 as scenes;

    const DIM: u8 = 3;

    mod dimension;
    pub(super) use dimension::compare;
}

fn main() -> ExitCode {
    run::run()
}
