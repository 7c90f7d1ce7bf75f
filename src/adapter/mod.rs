//! The adapter to Rapier: one source for all flavours, compiled once for each.
//!
//! It turns colliders into boxes, and changes of the pair set into Rapier's events. The proxy table keeps boxes, and the pair tracker finds
//! pairs. The module that includes this one names the engine `rapier`, and names `version` the code for its version: `rapier_027` or
//! `rapier_036`.

use super::{rapier, version};

mod broad_phase;
mod collider_box;
mod collider_key;
mod input;
mod outline;
mod query_tree;
#[cfg(feature = "serde-serialize")]
mod snapshot;
mod trial;

pub use broad_phase::UnisizeBroadPhase;
pub(crate) use input::Input;
pub use trial::{Difference, Measured, Trial, TrialReport};

/// [`Settings`](crate::Settings) with the scalar of this engine.
pub type Settings = crate::Settings<rapier::math::Real>;
