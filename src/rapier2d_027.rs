//! The broad phase for rapier2d 0.27.
//!
//! [`UnisizeBroadPhase`] takes the place of `DefaultBroadPhase`; [`Settings`] and [`Stats`] belong to it. It answers
//! queries about the scene as of the last update, by the same methods as Rapier's own:
//!
//! ```
//! use rapier2d::parry::query::DefaultQueryDispatcher;
//! use rapier2d::prelude::*;
//! use unisize::rapier2d_027::UnisizeBroadPhase;
//!
//! let (mut bodies, mut colliders) = (RigidBodySet::new(), ColliderSet::new());
//! let wall = colliders.insert(ColliderBuilder::cuboid(0.5, 5.0).translation(vector![4.0, 0.0]));
//! let sensor = ColliderBuilder::ball(1.0).sensor(true);
//! let sensor = colliders.insert(sensor.translation(vector![2.0, 0.0]));
//!
//! let mut broad_phase = UnisizeBroadPhase::new();
//! CollisionPipeline::new().step(
//!     IntegrationParameters::default().prediction_distance(),
//!     &mut broad_phase,
//!     &mut NarrowPhase::new(),
//!     &mut bodies,
//!     &mut colliders,
//!     &(),
//!     &(),
//! );
//!
//! let ray = Ray::new(Point::origin(), vector![1.0, 0.0]);
//! let scene = |filter| {
//!     broad_phase.as_query_pipeline(&DefaultQueryDispatcher, &bodies, &colliders, filter)
//! };
//! let everything = scene(QueryFilter::default()); // Builds the tree; later queries reuse it.
//! assert_eq!(everything.cast_ray(&ray, 100.0, true), Some((sensor, 1.0)));
//! let solids = scene(QueryFilter::default().exclude_sensors());
//! assert_eq!(solids.cast_ray(&ray, 100.0, true), Some((wall, 3.5)));
//! ```

use ::rapier2d as rapier;

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
