//! What the suite needs and Rapier spells differently in two dimensions.

use super::rapier::prelude::*;
use super::scenes::along;

/// A floor at height 0 of this half width, made of segments.
pub(super) fn mesh_floor(half: Real) -> ColliderBuilder {
    let corners = [-half, half].map(|x| along(0, x).into());
    ColliderBuilder::polyline(corners.to_vec(), None)
}

/// A hinge.
pub(super) fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new()
}
