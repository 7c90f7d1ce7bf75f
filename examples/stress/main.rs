//! Where small worlds fail, does unisize fail alone?
//!
//! ```text
//! cargo run --release --all-features --example stress
//! ```
//!
//! takes small worlds to their limits: high stacks, heavy things on light ones, chains with a heavy end, long time steps, places far
//! from the origin, tiny and huge sizes, fast spin and flight. Each case is run from several starts on Rapier's own broad phase and
//! on unisize, alone, and judged by a criterion that is computed (`criterion.rs`). Who fails is told by one rule for all cases
//! (`verdict.rs`): neither, both alike, or one alone. What is too little to be told in a case is told in all of them together
//! (`discordance.rs`). Three more checks leave nothing to chance:
//!
//! - unisize must not panic from a start from which Rapier's own does not;
//! - with the events of each update in order, both worlds must end alike to the bit;
//! - in one world, both must hold the same pairs after each step.
//!
//! Then whole worlds of 10,000 bodies are shifted by one vector between two steps, and it is measured what that costs.
//!
//! It prints tables in Markdown and draws `docs/figures/stress-*.svg`. It exits with 1 if unisize fails alone in a case or more often
//! in all of them, or if a check finds a difference, and with 2 if it was called wrongly or cannot write.

mod case;
mod caught;
mod chart;
mod criterion;
mod discordance;
mod end;
mod family;
mod options;
#[path = "../progress/bar.rs"]
mod progress;
mod row;
mod run;
mod shift;
mod table;
mod verdict;

use std::process::ExitCode;

/// The version of Rapier.
const RAPIER: &str = "0.27";

/// The level that leaves out what the default broad phase leaves out: with it, and with events in order, both do the same to the bit.
const FILTER_OF_DEFAULT: unisize::PairFilter = unisize::PairFilter::Off;

/// Whether the charts of this version are in the documentation.
const HAS_CHARTS: bool = true;

#[path = "."]
mod dim2 {
    //! The runs in rapier2d.
    use unisize::rapier2d_027 as ours;
    use unisize_scenes::dim2 as scenes;

    const DIM: u8 = 2;

    mod dimension;
    #[path = "flavour/dim2.rs"]
    mod flavour;
    #[path = "version/rapier_027.rs"]
    mod version;
    pub(super) use dimension::{shift, study};
}

#[path = "."]
mod dim3 {
    //! The runs in rapier3d.
    use unisize::rapier3d_027 as ours;
    use unisize_scenes::dim3 as scenes;

    const DIM: u8 = 3;

    mod dimension;
    #[path = "flavour/dim3.rs"]
    mod flavour;
    #[path = "version/rapier_027.rs"]
    mod version;
    pub(super) use dimension::{shift, study};
}

fn main() -> ExitCode {
    run::run()
}
