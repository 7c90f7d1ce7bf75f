//! The broad phases of the methods, in one flavour of Rapier.

#[cfg(not(feature = "rapier-036"))]
use super::grid::HashGrid;
use super::ours::{Settings, UnisizeBroadPhase};
use super::scenes::rapier::prelude::*;
use super::scenes::{OwnBroadPhase, Seldom, Steppable, install, lossy};
use crate::finder::{Finder, LOST_ONE_IN};

/// A broad phase of any method.
pub(super) type Created = Box<dyn Steppable + Send + Sync>;

/// Creates an empty broad phase for bodies of this typical size. The seed decides which pairs `Lossy` loses.
pub(super) fn create(finder: Finder, typical_size: Real, seed: u64) -> Created {
    let unisize = |margin: Option<f32>| {
        let settings = Settings::default();
        UnisizeBroadPhase::with_settings(match margin {
            None => settings,
            Some(sizes) => settings.with_margin(sizes * typical_size),
        })
    };
    match finder {
        Finder::Rapier => Box::new(DefaultBroadPhase::new()),
        Finder::Unisize(margin) => Box::new(install(unisize(margin))),
        Finder::Seldom(interval, margin) => {
            Box::new(install(Seldom::new(unisize(margin), interval)))
        }
        #[cfg(not(feature = "rapier-036"))]
        Finder::Grid(cell) => Box::new(HashGrid::new(cell)),
        Finder::Lossy => Box::new(install(lossy(OwnBroadPhase::new(), LOST_ONE_IN, seed))),
    }
}
