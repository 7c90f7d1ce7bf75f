//! What the suite needs and Rapier spells differently in three dimensions.

use super::rapier::{na::DMatrix, prelude::*};

/// A floor at height 0 of this half width, made of triangles.
pub(super) fn mesh_floor(half: Real) -> ColliderBuilder {
    let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
    let corners = corners.map(|[x, z]| point![x, 0.0, z]);
    let mesh = ColliderBuilder::trimesh(corners.to_vec(), vec![[0, 2, 1], [0, 3, 2]]);
    mesh.expect("the mesh has triangles")
}

/// A floor at height 0 of this half width, as a height field.
pub(super) fn height_field(half: Real) -> ColliderBuilder {
    ColliderBuilder::heightfield(DMatrix::zeros(9, 9), vector![2.0 * half, 1.0, 2.0 * half])
}

/// A hinge.
pub(super) fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new(Vector::z_axis())
}

/// A spin of this many radians per second.
pub(super) fn spin(speed: Real) -> AngVector<Real> {
    vector![0.3 * speed, 0.1 * speed, speed]
}
