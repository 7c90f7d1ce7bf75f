//! What the suite needs and Rapier spells differently in two dimensions.

use super::rapier::{na::DVector, prelude::*};

/// A floor at height 0 of this half width, made of segments.
pub(super) fn mesh_floor(half: Real) -> ColliderBuilder {
    ColliderBuilder::polyline(vec![point![-half, 0.0], point![half, 0.0]], None)
}

/// A floor at height 0 of this half width, as a height field.
pub(super) fn height_field(half: Real) -> ColliderBuilder {
    ColliderBuilder::heightfield(DVector::zeros(9), vector![2.0 * half, 1.0])
}

/// A hinge.
pub(super) fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new()
}

/// A spin of this many radians per second.
pub(super) fn spin(speed: Real) -> AngVector<Real> {
    speed
}
