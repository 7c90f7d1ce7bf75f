//! What the tests of the adapter need and Rapier spells differently in two dimensions.

use super::rapier::math::Real;
use super::version::AngVector;

/// A rotation vector, of which only the last component is needed.
pub(super) fn angular(_: Real, _: Real, z: Real) -> AngVector {
    z
}
