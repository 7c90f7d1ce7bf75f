//! Vectors and removals of Rapier 0.36, for a crowd.

use super::rapier::prelude::*;

pub(crate) fn vector(coordinates: [Real; DIM]) -> Vector {
    coordinates.into()
}

pub(crate) fn coordinates(collider: &Collider) -> [Real; DIM] {
    collider.translation().into()
}

pub(crate) fn remove(
    colliders: &mut ColliderSet,
    bodies: &mut RigidBodySet,
    handle: ColliderHandle,
) {
    let (islands, soft_bodies) = (&mut IslandManager::new(), &mut SoftBodySet::new());
    colliders.remove(handle, islands, bodies, soft_bodies, false);
}
