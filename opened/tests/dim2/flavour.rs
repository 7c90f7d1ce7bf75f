//! What the suite needs and Rapier spells differently in two dimensions.

use super::rapier::prelude::*;

/// Floors at height 0 of this half width that are not simple shapes.
pub(super) fn floors(half: Real) -> [ColliderBuilder; 2] {
    let corners = [Vector::X * -half, Vector::X * half];
    let heights = vec![0.0; 9];
    [
        ColliderBuilder::polyline(corners.to_vec(), None),
        ColliderBuilder::heightfield(heights, Vector::new(2.0 * half, 1.0)),
    ]
}

/// A hinge.
pub(super) fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new()
}

/// A spin of this many radians per second.
pub(super) fn spin(speed: Real) -> AngVector {
    speed
}

/// A disk of this radius.
pub(super) fn soft_body(centre: Vector, radius: Real) -> SoftBodyBuilder {
    SoftBodyBuilder::disk(centre, radius, 24)
}
