//! The broad phase for rapier3d 0.27.
//!
//! [`UnisizeBroadPhase`] takes the place of `DefaultBroadPhase`; [`Settings`] and [`Stats`] belong to it. Rapier's
//! pipelines update it; without a pipeline, lists of colliders can be given to it by hand:
//!
//! ```
//! use rapier3d::prelude::*;
//! use unisize::rapier3d_027::{Settings, UnisizeBroadPhase};
//!
//! let (bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
//! let [left, right, far] = [0.0, 0.9, 5.0].map(|x| {
//!     colliders.insert(ColliderBuilder::ball(0.5).translation(vector![x, 0.0, 0.0]))
//! });
//!
//! let settings = Settings::default().with_margin(0.05);
//! let mut broad_phase = UnisizeBroadPhase::with_settings(settings);
//! let params = IntegrationParameters::default();
//! let mut events = Vec::new();
//! broad_phase.update(&params, &colliders, &bodies, &[left, right, far], &[], &mut events);
//!
//! let [BroadPhasePairEvent::AddPair(pair)] = events[..] else { panic!("two of them touch") };
//! assert_eq!([pair.collider1, pair.collider2], [left, right]);
//! assert_eq!(broad_phase.pairs().count(), 1);
//! let stats = broad_phase.stats();
//! assert_eq!((stats.proxies, stats.pairs, stats.refused), (3, 1, 0));
//!
//! // Removed colliders have a list of their own, and their pairs end without an event.
//! broad_phase.update(&params, &colliders, &bodies, &[], &[right], &mut events);
//! assert_eq!((events.len(), broad_phase.stats().pairs), (1, 0));
//! ```
//!
//! How long each phase of an update takes, with the algorithm of the paper in place of the fast one:
//!
//! ```
//! # use rapier3d::prelude::*;
//! use unisize::rapier3d_027::{Kernel, Settings, UnisizeBroadPhase};
//!
//! let settings = Settings::default().with_kernel(Kernel::RankSweep).with_timed(true);
//! let mut broad_phase = UnisizeBroadPhase::with_settings(settings);
//! # let (bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
//! # let listed: Vec<_> = (0..1000).map(|i| {
//! #     let ball = ColliderBuilder::ball(0.5).translation(vector![0.9 * i as f32, 0.0, 0.0]);
//! #     colliders.insert(ball)
//! # }).collect();
//! # let params = IntegrationParameters::default();
//! # broad_phase.update(&params, &colliders, &bodies, &listed, &[], &mut Vec::new());
//! // ... after an update:
//! for (phase, time) in broad_phase.stats().times.by_name() {
//!     println!("{phase}: {time:?}");
//! }
//! # assert!(broad_phase.stats().times.total() > std::time::Duration::ZERO);
//! ```

use ::rapier3d as rapier;

#[path = "adapter/mod.rs"]
mod adapter;

#[cfg(test)]
#[path = "adapter/test_support/dim3.rs"]
mod test_support;

#[path = "adapter/rapier_027/mod.rs"]
mod version;

pub use crate::kernel::Kernel;
pub use crate::pair_filter::PairFilter;
pub use crate::stats::{Stats, Work};
pub use adapter::{Difference, Measured, Settings, Trial, TrialReport, UnisizeBroadPhase};
