//! The adapter to Rapier: one source for every flavour, compiled once in each.
//!
//! It turns colliders into boxes, and changes of the pair set into Rapier's events; how pairs are
//! found is none of its business. The module that includes it names the engine as `rapier`,
//! and what depends on the dimension as `dimension`.

use super::{dimension, rapier};

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
