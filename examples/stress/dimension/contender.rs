//! The broad phases that a case is run on.

use super::ours::UnisizeBroadPhase;
use super::scenes::rapier::geometry::{BvhOptimizationStrategy, DefaultBroadPhase};
use super::scenes::{Observed, OwnBroadPhase, Steppable, install};

/// A broad phase that a case is run on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Contender {
    /// Rapier's own.
    Rapier,
    /// unisize by its default settings.
    Ours,
    /// Rapier's own, with the events of each update sorted.
    RapierInOrder,
    /// The same, but its tree is never optimized.
    RapierOtherTree,
    /// unisize, with the events of each update sorted.
    OursInOrder,
    /// One that reports nothing, which must be found out.
    #[cfg(test)]
    Blind,
    /// One that panics, which must not be taken for Rapier's fault.
    #[cfg(test)]
    Panicking,
}

impl Contender {
    /// The same with its events in order.
    pub(super) fn in_order(self) -> Self {
        match self {
            Self::Rapier | Self::RapierInOrder => Self::RapierInOrder,
            Self::RapierOtherTree => Self::RapierOtherTree,
            Self::Ours | Self::OursInOrder => Self::OursInOrder,
            #[cfg(test)]
            Self::Blind | Self::Panicking => self,
        }
    }

    /// A new one without colliders.
    pub(super) fn create(self) -> Box<dyn Steppable> {
        match self {
            Self::Rapier => Box::new(DefaultBroadPhase::new()),
            Self::Ours => Box::new(install(UnisizeBroadPhase::new())),
            Self::RapierInOrder => Box::new(install(Observed::new(OwnBroadPhase::new()).sorted())),
            Self::RapierOtherTree => {
                let other =
                    OwnBroadPhase::with_optimization_strategy(BvhOptimizationStrategy::None);
                Box::new(install(Observed::new(other).sorted()))
            }
            Self::OursInOrder => Box::new(install(self.observed().sorted())),
            #[cfg(test)]
            Self::Blind | Self::Panicking => Box::new(install(self.observed())),
        }
    }

    /// unisize under observation, or what is put in its place.
    pub(super) fn observed(self) -> Observed<UnisizeBroadPhase> {
        let observed = Observed::new(UnisizeBroadPhase::new());
        match self {
            #[cfg(test)]
            Self::Blind => observed.silent(),
            #[cfg(test)]
            Self::Panicking => panic!("on purpose"),
            _ => observed,
        }
    }
}
