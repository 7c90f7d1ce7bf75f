//! What the suite needs and Rapier spells differently in three dimensions.

use super::rapier::prelude::*;
use super::version::{AngVector, triple, unit};

/// A floor at height 0 of this half width, made of triangles.
pub(super) fn mesh_floor(half: Real) -> ColliderBuilder {
    let corners = [[-half, -half], [half, -half], [half, half], [-half, half]];
    let corners = corners.map(|[x, z]| triple([x, 0.0, z]).into());
    let mesh = ColliderBuilder::trimesh(corners.to_vec(), vec![[0, 2, 1], [0, 3, 2]]);
    mesh.expect("the mesh has triangles")
}

/// A hinge.
pub(super) fn hinge() -> RevoluteJointBuilder {
    RevoluteJointBuilder::new(unit(triple([0.0, 0.0, 1.0])))
}

/// A spin of this many radians per second.
pub(super) fn spin(speed: Real) -> AngVector {
    triple([0.3 * speed, 0.1 * speed, speed])
}
