//! What the adapter needs and Rapier spells differently in two dimensions.

use super::rapier::math::{AngVector, Real, Rotation};

/// The rotation as an angle.
pub(super) fn scaled_axis(rotation: &Rotation<Real>) -> AngVector<Real> {
    rotation.angle()
}

/// A rotation vector, of which only the last component is needed.
#[cfg(test)]
pub(super) fn angular(_: Real, _: Real, z: Real) -> AngVector<Real> {
    z
}
