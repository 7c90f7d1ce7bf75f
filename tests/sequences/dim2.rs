//! What the suite needs and is otherwise in the plane.

use super::rapier::prelude::Real;
#[cfg(test)]
use super::suite::Solid;
use crate::ops::Triple;

/// Solids of revolution: there are none in the plane.
#[cfg(test)]
pub(super) const SOLIDS: [(&str, Solid); 0] = [];

/// A turn, by the first angle.
pub(super) fn turn(angles: Triple) -> Real {
    angles[0].into()
}
