//! What the time buys: errors against the computing time for one simulated second, on Rapier's own broad phase and on unisize.
//!
//! ```text
//! cargo run --release --all-features --example accuracy
//! ```
//!
//! simulates scenes in which it is known what should come out, with four time steps, in `f32` and in `f64`, from starts that
//! differ a little by their seed. A *gauge* measures each error by Rapier's world alone, so that it sees what a broad phase has
//! lost. Three things are printed as tables in Markdown, and the first of them is drawn to `docs/figures/accuracy-*.svg`:
//!
//! - the **errors**, and the time of the processor for them: medians over the seeds, with their intervals of 95 %;
//! - whether unisize can be **told apart** from Rapier's own broad phase by any error in any scene: a test on the same starts,
//!   corrected for the number of tests;
//! - whether the tests would **notice** a broad phase that loses one pair in a thousand.
//!
//! The solver goes through contacts in the order in which their pairs were reported, and in a calm scene another order can have a
//! tiny effect that is always the same. So what is told apart is simulated again with the events of both in the same order: if they
//! find the same pairs, the runs are then equal bit for bit: in all errors, and in the poses and velocities of all bodies at the
//! end. The program exits with 1 if they are not, or if the control is told apart in no scene, and with 2 if it was called wrongly
//! or cannot write. With fewer than 15 seeds, or with `--quick`, it says nothing of either.
//!
//! All is on one thread, whatever features are on.

mod case;
mod chart;
mod options;
#[path = "../progress/bar.rs"]
mod progress;
mod run;
mod scene;
mod statistics;
mod study;
mod table;
mod verdict;

use case::{Case, Run, Scalar};
use std::process::ExitCode;

/// The version of Rapier.
const RAPIER: &str = "0.27";

/// The level that leaves out what the default broad phase leaves out: with it, and with events in order, both do the same to the bit.
const FILTER_OF_DEFAULT: unisize::PairFilter = unisize::PairFilter::Off;

/// What the names of its charts end with.
const SUFFIX: &str = "";

/// What there is of it.
const SCALARS: &[Scalar] = &[Scalar::F32, Scalar::F64];

#[path = "."]
mod dim2 {
    //! The simulations in rapier2d.
    use scenes::rapier::prelude::JointAxesMask;
    use unisize::rapier2d_027 as ours;
    use unisize_scenes::dim2 as scenes;

    /// What the joint of a pendulum holds together.
    const PIN: JointAxesMask = JointAxesMask::LOCKED_REVOLUTE_AXES;

    mod dimension;
    #[path = "rapier_027.rs"]
    mod version;
    pub(super) use dimension::run;
}

#[path = "."]
mod dim3 {
    //! The simulations in rapier3d.
    use scenes::rapier::prelude::JointAxesMask;
    use unisize::rapier3d_027 as ours;
    use unisize_scenes::dim3 as scenes;

    /// What the joint of a pendulum holds together.
    const PIN: JointAxesMask = JointAxesMask::LOCKED_SPHERICAL_AXES;

    mod dimension;
    #[path = "rapier_027.rs"]
    mod version;
    pub(super) use dimension::run;
}

#[path = "."]
mod dim2_f64 {
    //! The simulations in rapier2d-f64.
    use scenes::rapier::prelude::JointAxesMask;
    use unisize::rapier2d_f64_027 as ours;
    use unisize_scenes::dim2_f64 as scenes;

    /// What the joint of a pendulum holds together.
    const PIN: JointAxesMask = JointAxesMask::LOCKED_REVOLUTE_AXES;

    mod dimension;
    #[path = "rapier_027.rs"]
    mod version;
    pub(super) use dimension::run;
}

#[path = "."]
mod dim3_f64 {
    //! The simulations in rapier3d-f64.
    use scenes::rapier::prelude::JointAxesMask;
    use unisize::rapier3d_f64_027 as ours;
    use unisize_scenes::dim3_f64 as scenes;

    /// What the joint of a pendulum holds together.
    const PIN: JointAxesMask = JointAxesMask::LOCKED_SPHERICAL_AXES;

    mod dimension;
    #[path = "rapier_027.rs"]
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
