//! What is spelled differently in three dimensions.

use super::scenes::rapier::prelude::*;
use super::version::AngVector;

/// A spin or a rotation at this speed, on each axis this share of it.
pub(super) fn spin(speed: Real, share: [Real; 3]) -> AngVector {
    let mut spin = AngVector::default();
    for axis in 0..3 {
        spin[axis] = speed * share[axis];
    }
    spin
}
