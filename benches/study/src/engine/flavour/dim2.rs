//! What is spelled differently in two dimensions.

use super::scenes::rapier::prelude::*;
use super::version::AngVector;

/// A spin or a rotation about the third axis, whatever the other shares are.
pub(super) fn spin(speed: Real, _share: [Real; 3]) -> AngVector {
    speed
}
