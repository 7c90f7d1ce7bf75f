//! The broad phase for rapier3d-f64 0.36.
//!
//! Rapier 0.36 has no trait for broad phases: its pipelines take only their own. With a copy of Rapier that `open-rapier` has
//! opened, `DefaultBroadPhase::custom(UnisizeBroadPhase::new())` takes the place of `DefaultBroadPhase::new()` in all of
//! them. Without one, sensors, crowds, and particles with dynamics of their own do not need the pipelines:
//! [`UnisizeBroadPhase::update`] has the arguments of `BroadPhaseBvh::update`, gives the same events, and filters pairs in
//! the same way, and [`UnisizeBroadPhase::set_aabb`] hands over boxes that are known. `docs/newest-rapier.md` says more.

use ::rapier3d_f64_0_36 as rapier;

#[path = "adapter/mod.rs"]
mod adapter;

#[cfg(test)]
#[path = "adapter/dim3.rs"]
mod dimension;

#[path = "adapter/rapier_0_36/mod.rs"]
mod version;

#[cfg(opened_rapier3d_f64)]
#[path = "adapter/rapier_0_36/seam.rs"]
mod seam;

pub use crate::{Kernel, PairFilter, Stats, Work};
pub use adapter::{Settings, UnisizeBroadPhase};
