//! The adapter to Rapier: one source for every flavour, compiled once in each.
//!
//! It turns colliders into boxes, and changes of the pair set into Rapier's events; which boxes are kept and how pairs are
//! found is none of its business. The module that includes it names the engine as `rapier`, and as `version` what
//! depends on the engine's version: `rapier_027` or `rapier_036`.

use super::{rapier, version};

mod broad_phase;
mod collider_box;
mod collider_key;
mod outline;
mod query_tree;
#[cfg(feature = "serde-serialize")]
mod snapshot;
mod trial;

pub(crate) use broad_phase::Input;
pub use broad_phase::UnisizeBroadPhase;
#[allow(unused_imports, reason = "only Rapier 0.36 is looked on at")]
pub(crate) use trial::key;
pub use trial::{Difference, Measured, Trial, TrialReport};

/// [`Settings`](crate::Settings) in the numbers of this engine.
pub type Settings = crate::Settings<rapier::math::Real>;
