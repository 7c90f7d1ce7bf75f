//! The setup of the broad phases on stage.

use crate::choice::Choice;
use clap::ValueEnum;

/// The settings that can change during a simulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Setup {
    /// The broad phase whose pairs are reported to Rapier.
    pub(crate) choice: Choice,
    /// Whether the other one gets the same colliders, so that both are timed.
    pub(crate) times_both: bool,
    pub(crate) kernel: KernelName,
    /// As in unisize's settings.
    pub(crate) margin: f32,
}

/// The margin of Rapier's own broad phase, and the default of unisize.
pub(crate) const RAPIERS_MARGIN: f32 = 0.01;

/// A kernel of unisize.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum KernelName {
    /// The fast kernel
    GridSweep,
    /// The algorithm of Capannini and Larsson
    RankSweep,
    /// Every box against every other
    BruteForce,
}

impl KernelName {
    pub(crate) const ALL: [Self; 3] = [Self::GridSweep, Self::RankSweep, Self::BruteForce];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::GridSweep => "GridSweep",
            Self::RankSweep => "RankSweep",
            Self::BruteForce => "BruteForce",
        }
    }
}
