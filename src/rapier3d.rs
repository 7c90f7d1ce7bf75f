//! The broad phase for rapier3d 0.27.
//!
//! [`UnisizeBroadPhase`] takes the place of `DefaultBroadPhase`; [`Settings`] and [`Stats`] belong to it.

use ::rapier3d as rapier;

#[path = "adapter/mod.rs"]
mod adapter;

#[path = "adapter/dim3.rs"]
mod dimension;

pub use adapter::{Kernel, Settings, Stats, UnisizeBroadPhase};
