//! Rotations and normals that are not of unit length, in Rapier 0.36. The module around the one that includes it imports the engine as `rapier`.

use super::super::rapier::math::{Pose, Real};
use super::super::rapier::parry::math::{Rot2, Rot3};
use super::super::rapier::prelude::SharedShape;

/// The pose with a rotation that is this many times as long.
pub(crate) fn stretched(mut pose: Pose, factor: Real) -> Pose {
    pose.rotation = pose.rotation.stretched(factor);
    pose
}

/// The half-space with a normal that is this many times as long; any other shape stays.
pub(crate) fn stretched_half_space(shape: SharedShape, factor: Real) -> SharedShape {
    match shape.as_halfspace() {
        Some(half_space) => SharedShape::halfspace(half_space.normal * factor),
        None => shape,
    }
}

/// A rotation of the plane or of space.
trait Stretched {
    fn stretched(self, factor: Real) -> Self;
}

impl Stretched for Rot2 {
    fn stretched(self, factor: Real) -> Self {
        Self::from_cos_sin_unchecked(self.re * factor, self.im * factor)
    }
}

impl Stretched for Rot3 {
    fn stretched(self, factor: Real) -> Self {
        self * factor
    }
}
