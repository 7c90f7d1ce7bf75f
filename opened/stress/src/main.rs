//! Where small worlds fail in Rapier 0.36, does unisize fail alone?
//!
//! ```text
//! cargo run --release --package stress-opened
//! ```
//!
//! The same program as `examples/stress`, which says what is looked at, on an opened copy of Rapier. Its charts go to `stress` in
//! the target directory unless `--out` names another folder.

#[path = "../../../examples/stress/case.rs"]
mod case;
#[path = "../../../examples/stress/caught.rs"]
mod caught;
#[path = "../../../examples/stress/chart.rs"]
mod chart;
#[path = "../../../examples/stress/criterion.rs"]
mod criterion;
#[path = "../../../examples/stress/discordance.rs"]
mod discordance;
#[path = "../../../examples/stress/end.rs"]
mod end;
#[path = "../../../examples/stress/family.rs"]
mod family;
#[path = "../../../examples/stress/options.rs"]
mod options;
#[path = "../../../examples/progress/bar.rs"]
mod progress;
#[path = "../../../examples/stress/row.rs"]
mod row;
#[path = "../../../examples/stress/run.rs"]
mod run;
#[path = "../../../examples/stress/shift.rs"]
mod shift;
#[path = "../../../examples/stress/table.rs"]
mod table;
#[path = "../../../examples/stress/verdict.rs"]
mod verdict;

use std::process::ExitCode;

/// The version of Rapier.
const RAPIER: &str = "0.36";

/// The level that leaves out what the default broad phase leaves out: with it, and with events in order, both do the same to the bit.
const FILTER_OF_DEFAULT: unisize::PairFilter = unisize::PairFilter::Groups;

/// Whether the charts of this version are in the documentation.
const HAS_CHARTS: bool = false;

#[path = "../../../examples/stress"]
mod dim2 {
    //! The runs in rapier2d.
    use unisize::rapier2d_036 as ours;
    use unisize_scenes::dim2_036 as scenes;

    const DIM: u8 = 2;

    mod dimension;
    #[path = "flavour/dim2.rs"]
    mod flavour;
    #[path = "version/rapier_036.rs"]
    mod version;
    pub(super) use dimension::{shift, study};
}

#[path = "../../../examples/stress"]
mod dim3 {
    //! The runs in rapier3d.
    use unisize::rapier3d_036 as ours;
    use unisize_scenes::dim3_036 as scenes;

    const DIM: u8 = 3;

    mod dimension;
    #[path = "flavour/dim3.rs"]
    mod flavour;
    #[path = "version/rapier_036.rs"]
    mod version;
    pub(super) use dimension::{shift, study};
}

fn main() -> ExitCode {
    run::run()
}
