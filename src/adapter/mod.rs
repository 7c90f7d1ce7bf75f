//! The adapter to Rapier: one source for every flavour, compiled once in each.
//!
//! It turns colliders into boxes, and changes of the pair set into Rapier's events; how pairs are
//! found is none of its business. The module that includes it names the engine as `rapier`, and as `version` what
//! depends on the engine's version: `rapier_0_27` or `rapier_0_36`. What the tests need for a dimension is in
//! `dimension`.

#[cfg(test)]
use super::dimension;
use super::{rapier, version};

mod broad_phase;
mod collider_box;
mod outline;
mod queries;
mod reading_order;
mod reading_part;
mod settings;
#[cfg(feature = "serde-serialize")]
mod snapshot;
mod stats;
mod world;

pub use broad_phase::UnisizeBroadPhase;
pub use settings::{Kernel, Settings};
pub use stats::Stats;
