//! What the suite needs and Rapier spells differently in two dimensions.

use super::rapier::prelude::*;
use super::version::{AngVector, triple};

/// A floor at height 0 of this half width, made of segments.
pub(super) fn mesh_floor(half: Real) -> ColliderBuilder {
    let corners = [-half, half].map(|x| triple([x, 0.0, 0.0]).into());
    ColliderBuilder::polyline(corners.to_vec(), None)
}

/// A hinge.
pub(super) fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new()
}

/// A spin of this many radians per second.
pub(super) fn spin(speed: Real) -> AngVector {
    speed
}
