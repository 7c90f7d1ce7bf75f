//! The broad phases for Rapier 0.27, each with a world of its own.

use super::Create;
use super::contestant::{Contestant, nothing};
use super::ours::UnisizeBroadPhase;
use super::rapier::prelude::{DIM, DefaultBroadPhase};

/// That of this repository.
pub(in crate::updates) const OURS: Create<DIM> =
    |case| Box::new(Contestant::new(case, UnisizeBroadPhase::new(), nothing));

/// The one that it replaces.
pub(in crate::updates) const DEFAULT: Create<DIM> =
    |case| Box::new(Contestant::new(case, DefaultBroadPhase::new(), nothing));
