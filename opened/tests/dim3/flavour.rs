//! What the suite needs and Rapier spells differently in three dimensions.

use super::rapier::parry::utils::Array2;
use super::rapier::prelude::*;

/// Floors at height 0 of this half width that are not simple shapes.
pub(super) fn floors(half: Real) -> [ColliderBuilder; 2] {
    let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
    let corners = corners.map(|[x, z]| Vector::new(x, 0.0, z));
    let mesh = ColliderBuilder::trimesh(corners.to_vec(), vec![[0, 2, 1], [0, 3, 2]]);
    let heights = Array2::repeat(9, 9, 0.0);
    [
        mesh.expect("the mesh has triangles"),
        ColliderBuilder::heightfield(heights, Vector::new(2.0 * half, 1.0, 2.0 * half)),
    ]
}

/// A hinge.
pub(super) fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new(Vector::Z)
}

/// A spin of this many radians per second.
pub(super) fn spin(speed: Real) -> AngVector {
    AngVector::new(0.3 * speed, 0.1 * speed, speed)
}

/// A cube of this half side.
pub(super) fn soft_body(centre: Vector, half: Real) -> SoftBodyBuilder {
    SoftBodyBuilder::cuboid(centre, Vector::splat(half), 4, 4, 4)
}
