//! What the suite needs and Rapier spells differently in three dimensions.

use super::rapier::prelude::*;
use super::scenes::along;
use super::version::unit;

/// A floor at height 0 of this half width, made of triangles.
pub(super) fn mesh_floor(half: Real) -> ColliderBuilder {
    let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
    let corners = corners.map(|[x, z]| (along(0, x) + along(2, z)).into());
    let mesh = ColliderBuilder::trimesh(corners.to_vec(), vec![[0, 2, 1], [0, 3, 2]]);
    mesh.expect("the mesh has triangles")
}

/// A hinge.
pub(super) fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new(unit(along(2, 1.0)))
}
