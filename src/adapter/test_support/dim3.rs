//! What the tests of the adapter need and Rapier spells differently in three dimensions.

use super::rapier::math::Real;
use super::version::AngVector;

/// A rotation vector.
pub(super) fn angular(x: Real, y: Real, z: Real) -> AngVector {
    AngVector::new(x, y, z)
}
