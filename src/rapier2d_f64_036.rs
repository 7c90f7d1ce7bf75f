//! The broad phase for rapier2d-f64 0.36.
//!
#![doc = include_str!("adapter/rapier_036/module.md")]

use ::rapier2d_f64_036 as rapier;

#[path = "adapter/mod.rs"]
mod adapter;

#[cfg(test)]
#[path = "adapter/test_support/dim2.rs"]
mod test_support;

#[path = "adapter/rapier_036/mod.rs"]
mod version;

#[cfg(opened_rapier2d_f64)]
#[path = "adapter/rapier_036/seam.rs"]
mod seam;

pub use crate::kernel::Kernel;
pub use crate::pair_filter::PairFilter;
pub use crate::stats::{Stats, Work};
pub use adapter::{Difference, Measured, Settings, Trial, TrialReport, UnisizeBroadPhase};
