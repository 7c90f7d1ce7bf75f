//! Vectors and removals of Rapier 0.27, for a crowd.

use super::rapier::prelude::*;

pub(crate) fn vector(coordinates: [Real; DIM]) -> Vector<Real> {
    coordinates.into()
}

pub(crate) fn coordinates(collider: &Collider) -> [Real; DIM] {
    (*collider.translation()).into()
}

pub(crate) fn remove(
    colliders: &mut ColliderSet,
    bodies: &mut RigidBodySet,
    handle: ColliderHandle,
) {
    colliders.remove(handle, &mut IslandManager::new(), bodies, false);
}
