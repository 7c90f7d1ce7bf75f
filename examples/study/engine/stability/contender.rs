//! The broad phases that a case is run on.

use super::ours::{Settings, UnisizeBroadPhase};
use super::scenes::rapier::prelude::DefaultBroadPhase;
use super::scenes::{Observed, OwnBroadPhase, Steppable, install};
use super::version;

/// A broad phase that a case is run on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Contender {
    /// Rapier's own.
    Rapier,
    /// unisize by its default settings.
    Ours,
    /// Rapier's own, with the events of each update sorted.
    RapierInOrder,
    /// unisize, with the events of each update sorted.
    OursInOrder,
    /// The same, where a step finds the tree of Rapier's own.
    OursOnRapiersTree,
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
            Self::OursOnRapiersTree => Self::OursOnRapiersTree,
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
            Self::OursInOrder => Box::new(install(self.observed().sorted())),
            Self::OursOnRapiersTree => {
                Box::new(install(version::on_rapiers_tree(self.observed().sorted())))
            }
            #[cfg(test)]
            Self::Blind | Self::Panicking => Box::new(install(self.observed())),
        }
    }

    /// unisize with the default's pairs, under observation, or what is put in its place.
    pub(super) fn observed(self) -> Observed<UnisizeBroadPhase> {
        let settings = Settings::default().with_filter(crate::FILTER_OF_DEFAULT);
        let observed = Observed::new(UnisizeBroadPhase::with_settings(settings));
        match self {
            #[cfg(test)]
            Self::Blind => observed.silent(),
            #[cfg(test)]
            Self::Panicking => panic!("on purpose"),
            _ => observed,
        }
    }
}
