//! The broad phase for rapier2d-f64 0.27.
//!
//! [`UnisizeBroadPhase`] takes the place of `DefaultBroadPhase`; [`Settings`] and [`Stats`] belong to it.

use ::rapier2d_f64 as rapier;

#[path = "adapter/mod.rs"]
mod adapter;

#[cfg(test)]
#[path = "adapter/test_support/dim2.rs"]
mod test_support;

#[path = "adapter/rapier_027/mod.rs"]
mod version;

pub use crate::kernel::Kernel;
pub use crate::pair_filter::PairFilter;
pub use crate::stats::{Stats, Work};
pub use adapter::{Difference, Measured, Settings, Trial, TrialReport, UnisizeBroadPhase};
