//! What the adapter needs and Rapier spells differently in three dimensions.

use super::rapier::math::{AngVector, Real, Rotation};

/// The rotation as an axis times an angle.
pub(super) fn scaled_axis(rotation: &Rotation<Real>) -> AngVector<Real> {
    rotation.scaled_axis()
}

/// A rotation vector.
#[cfg(test)]
pub(super) fn angular(x: Real, y: Real, z: Real) -> AngVector<Real> {
    AngVector::new(x, y, z)
}
