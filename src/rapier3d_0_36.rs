//! The broad phase for rapier3d 0.36, for programs that drive collision detection by themselves.
//!
//! Rapier 0.36 has no trait for broad phases: its pipelines take only their own. But sensors, crowds, and particles with
//! dynamics of their own do not need the pipelines. [`UnisizeBroadPhase::update`] has the arguments of
//! `BroadPhaseBvh::update`, gives the same events, and filters pairs in the same way; `docs/newest-rapier.md` says what
//! is possible and what is not.

use ::rapier3d_0_36 as rapier;

#[path = "adapter/mod.rs"]
mod adapter;

#[cfg(test)]
#[path = "adapter/dim3.rs"]
mod dimension;

#[path = "adapter/rapier_0_36/mod.rs"]
mod version;

pub use crate::{Kernel, PairFilter, Stats, Work};
pub use adapter::{Settings, UnisizeBroadPhase};
