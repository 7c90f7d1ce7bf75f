//! What is spelled differently in three dimensions.

use super::scenes::rapier::prelude::*;
use super::version::AngVector;

/// What a joint of a chain holds together.
pub(super) const PIN: JointAxesMask = JointAxesMask::LOCKED_SPHERICAL_AXES;

/// The rotation that lays a capsule along the first axis.
pub(super) fn lying() -> AngVector {
    spin(core::f64::consts::FRAC_PI_2 as Real, [0.0, 0.0, 1.0])
}

/// Whether a body spins at a finite speed.
pub(super) fn has_finite_spin(body: &RigidBody) -> bool {
    (0..3).all(|axis| body.angvel()[axis].is_finite())
}

/// A spin at this speed, on each axis this share of it.
pub(super) fn spin(speed: Real, share: [Real; 3]) -> AngVector {
    let mut spin = AngVector::default();
    for axis in 0..3 {
        spin[axis] = speed * share[axis];
    }
    spin
}
