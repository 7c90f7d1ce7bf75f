//! Rotations and normals that are not of unit length, in Rapier 0.27. The module around the one that includes it imports the engine as `rapier`.

use super::super::rapier::math::{Isometry, Real};
use super::super::rapier::na::Unit;
use super::super::rapier::prelude::SharedShape;

/// The pose with a rotation that is this many times as long.
pub(crate) fn stretched(mut pose: Isometry<Real>, factor: Real) -> Isometry<Real> {
    pose.rotation = Unit::new_unchecked(pose.rotation.into_inner() * factor);
    pose
}

/// The half-space with a normal that is this many times as long; any other shape stays.
pub(crate) fn stretched_half_space(shape: SharedShape, factor: Real) -> SharedShape {
    match shape.as_halfspace() {
        Some(half_space) => {
            SharedShape::halfspace(Unit::new_unchecked(*half_space.normal * factor))
        }
        None => shape,
    }
}
