//! The broad phases for Rapier 0.36, each with a world of its own.

use super::Create;
use super::contestant::{Contestant, nothing};
use super::deferred::Deferred;
use super::ours::UnisizeBroadPhase;
use super::rapier::prelude::{DIM, DefaultBroadPhase};
use unisize::{PairFilter, Settings};

/// That of this repository, at the level that leaves out what the default does, so that both hold the same pairs.
pub(in crate::updates) const OURS: Create<DIM> = |case| {
    let settings = Settings::default().with_filter(PairFilter::Groups);
    let broad_phase = UnisizeBroadPhase::with_settings(settings);
    Box::new(Contestant::new(case, broad_phase, nothing))
};

/// The one that it replaces.
pub(in crate::updates) const DEFAULT: Create<DIM> = |case| {
    let mut deferred = Deferred::default();
    let time = move |broad_phase: &_, frames: &_| deferred.time(broad_phase, frames);
    Box::new(Contestant::new(case, DefaultBroadPhase::new(), time))
};
