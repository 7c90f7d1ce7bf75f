//! The broad phase for rapier3d 0.36.
//!
#![doc = include_str!("adapter/rapier_036/module.md")]
#![cfg_attr(not(opened_rapier3d), doc = include_str!("adapter/rapier_036/unopened.md"))]

use ::rapier3d_036 as rapier;

#[path = "adapter/mod.rs"]
mod adapter;

#[cfg(test)]
#[path = "adapter/test_support/dim3.rs"]
mod test_support;

#[path = "adapter/rapier_036/mod.rs"]
mod version;

#[cfg(opened_rapier3d)]
#[path = "adapter/rapier_036/seam.rs"]
mod seam;

pub use crate::kernel::Kernel;
pub use crate::pair_filter::PairFilter;
pub use crate::stats::{Stats, Work};
pub use adapter::{Difference, Measured, Settings, Trial, TrialReport, UnisizeBroadPhase};
