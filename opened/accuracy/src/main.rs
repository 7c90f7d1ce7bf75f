//! What the time buys in Rapier 0.36: errors against the computing time for one simulated second, on its own broad phase and on
//! unisize.
//!
//! ```text
//! cargo run --release --package accuracy-opened
//! ```
//!
//! The same program as `examples/accuracy`, which says what is measured, on opened copies of Rapier. From the
//! root of the repository it draws `docs/figures/accuracy-*-0-36.svg`.

#[path = "../../../examples/accuracy/case.rs"]
mod case;
#[path = "../../../examples/accuracy/chart.rs"]
mod chart;
#[path = "../../../examples/accuracy/options.rs"]
mod options;
#[path = "../../../examples/progress/bar.rs"]
mod progress;
#[path = "../../../examples/accuracy/run.rs"]
mod run;
#[path = "../../../examples/accuracy/scene.rs"]
mod scene;
#[path = "../../../examples/accuracy/statistics/mod.rs"]
mod statistics;
#[path = "../../../examples/accuracy/study.rs"]
mod study;
#[path = "../../../examples/accuracy/table.rs"]
mod table;
#[path = "../../../examples/accuracy/verdict.rs"]
mod verdict;

use case::{Case, Run, Scalar};
use std::process::ExitCode;

/// The version of Rapier.
const RAPIER: &str = "0.36";

/// The level that leaves out what the default broad phase leaves out: with it, and with events in order, both do the same to the bit.
const FILTER_OF_DEFAULT: unisize::PairFilter = unisize::PairFilter::Groups;

/// What the names of its charts end with.
const SUFFIX: &str = "-0-36";

/// What there is of it.
const SCALARS: &[Scalar] = &[Scalar::F32, Scalar::F64];

#[path = "../../../examples/accuracy"]
mod dim2 {
    //! The simulations in rapier2d.
    use scenes::rapier::prelude::JointAxesMask;
    use unisize::rapier2d_036 as ours;
    use unisize_scenes::dim2_036 as scenes;

    /// What the joint of a pendulum holds together.
    const PIN: JointAxesMask = JointAxesMask::LOCKED_REVOLUTE_AXES;

    mod dimension;
    #[path = "rapier_036.rs"]
    mod version;
    pub(super) use dimension::run;
}

#[path = "../../../examples/accuracy"]
mod dim3 {
    //! The simulations in rapier3d.
    use scenes::rapier::prelude::JointAxesMask;
    use unisize::rapier3d_036 as ours;
    use unisize_scenes::dim3_036 as scenes;

    /// What the joint of a pendulum holds together.
    const PIN: JointAxesMask = JointAxesMask::LOCKED_SPHERICAL_AXES;

    mod dimension;
    #[path = "rapier_036.rs"]
    mod version;
    pub(super) use dimension::run;
}

#[path = "../../../examples/accuracy"]
mod dim2_f64 {
    //! The simulations in rapier2d-f64.
    use scenes::rapier::prelude::JointAxesMask;
    use unisize::rapier2d_f64_036 as ours;
    use unisize_scenes::dim2_f64_036 as scenes;

    /// What the joint of a pendulum holds together.
    const PIN: JointAxesMask = JointAxesMask::LOCKED_REVOLUTE_AXES;

    mod dimension;
    #[path = "rapier_036.rs"]
    mod version;
    pub(super) use dimension::run;
}

#[path = "../../../examples/accuracy"]
mod dim3_f64 {
    //! The simulations in rapier3d-f64.
    use scenes::rapier::prelude::JointAxesMask;
    use unisize::rapier3d_f64_036 as ours;
    use unisize_scenes::dim3_f64_036 as scenes;

    /// What the joint of a pendulum holds together.
    const PIN: JointAxesMask = JointAxesMask::LOCKED_SPHERICAL_AXES;

    mod dimension;
    #[path = "rapier_036.rs"]
    mod version;
    pub(super) use dimension::run;
}

/// Simulates a case in one flavour of Rapier.
fn simulate(dim: u8, scalar: Scalar, case: &Case) -> Run {
    match (dim, scalar) {
        (2, Scalar::F32) => dim2::run(case),
        (2, Scalar::F64) => dim2_f64::run(case),
        (_, Scalar::F32) => dim3::run(case),
        (_, Scalar::F64) => dim3_f64::run(case),
    }
}

fn main() -> ExitCode {
    run::run()
}
