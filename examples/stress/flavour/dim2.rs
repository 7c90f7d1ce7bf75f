//! What is spelled differently in two dimensions.

use super::scenes::rapier::prelude::*;
use super::version::AngVector;

/// What a joint of a chain holds together.
pub(super) const PIN: JointAxesMask = JointAxesMask::LOCKED_REVOLUTE_AXES;

/// The rotation that lays a capsule along the first axis.
pub(super) fn lying() -> AngVector {
    core::f64::consts::FRAC_PI_2 as Real
}

/// Whether a body spins at a finite speed.
pub(super) fn has_finite_spin(body: &RigidBody) -> bool {
    body.angvel().is_finite()
}

/// A spin at this speed.
pub(super) fn spin(speed: Real, _share: [Real; 3]) -> AngVector {
    speed
}
