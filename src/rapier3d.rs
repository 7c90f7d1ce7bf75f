//! The broad phase for rapier3d 0.27.
//!
//! [`UnisizeBroadPhase`] takes the place of `DefaultBroadPhase`; [`Settings`] and [`Stats`] belong to it.

use ::rapier3d as rapier;

#[path = "adapter/mod.rs"]
mod adapter;

#[cfg(test)]
#[path = "adapter/dim3.rs"]
mod dimension;

#[path = "adapter/rapier_0_27/mod.rs"]
mod version;

pub use adapter::{Kernel, Settings, Stats, UnisizeBroadPhase};
