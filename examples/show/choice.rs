//! The choice of a broad phase.

use clap::ValueEnum;

/// The broad phase that drives the simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Choice {
    /// This library
    Unisize,
    /// Rapier's own
    Default,
}

impl Choice {
    /// Its name in a legend.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Unisize => "unisize",
            Self::Default => "Rapier's default",
        }
    }

    /// The line of code that chooses it.
    pub(crate) fn line(self) -> &'static str {
        match self {
            Self::Unisize => "let mut broad_phase = UnisizeBroadPhase::new();",
            Self::Default => "let mut broad_phase = DefaultBroadPhase::new();",
        }
    }
}
