//! The broad phases of the methods, in one flavour of Rapier.

use super::ours::{Settings, UnisizeBroadPhase};
use super::scenes::rapier::prelude::*;
use super::scenes::{OwnBroadPhase, Steppable, install, lossy};
use super::seldom::Seldom;
use super::version;
use crate::finder::{Finder, LOST_ONE_IN};

/// A broad phase that can be a part of another one.
pub(super) type Created = Box<dyn Steppable + Send + Sync>;

/// An empty broad phase, of bodies of this typical size. A seed decides what is lost on purpose.
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
        Finder::Grid(cell) => {
            Box::new(version::hash_grid(cell).expect("this version steps on grids"))
        }
        Finder::Lossy => {
            let (control, _) = lossy(OwnBroadPhase::new(), LOST_ONE_IN, seed);
            Box::new(install(control))
        }
    }
}
