//! The broad phase for rapier2d 0.27.
//!
//! [`UnisizeBroadPhase`] takes the place of `DefaultBroadPhase`; [`Settings`] and [`Stats`] belong to it.

use ::rapier2d as rapier;
use rapier::math::{AngVector, Real, Rotation};

#[path = "adapter/mod.rs"]
mod adapter;

pub use adapter::{Kernel, Settings, Stats, UnisizeBroadPhase};

/// The rotation as an axis times an angle, or as an angle alone in two dimensions.
fn scaled_axis(rotation: &Rotation<Real>) -> AngVector<Real> {
    rotation.angle()
}

/// A rotation vector, of which two dimensions need only the last component.
#[cfg(test)]
fn angular(_: Real, _: Real, z: Real) -> AngVector<Real> {
    z
}
