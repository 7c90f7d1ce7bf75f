//! Conversions of boxes and handles between the engine's types and ours.

use super::rapier::geometry::{Aabb as RapierAabb, ColliderHandle};
use super::rapier::math::{DIM, Real};
use crate::aabb::Aabb;
use crate::proxy_table::Handle;

impl From<RapierAabb> for Aabb<Real, DIM> {
    fn from(aabb: RapierAabb) -> Self {
        Self::new(aabb.mins.into(), aabb.maxs.into())
    }
}

impl From<Aabb<Real, DIM>> for RapierAabb {
    fn from(aabb: Aabb<Real, DIM>) -> Self {
        Self::new(aabb.mins.into(), aabb.maxs.into())
    }
}

impl Handle for ColliderHandle {
    fn from_raw_parts(slot: u32, generation: u32) -> Self {
        Self::from_raw_parts(slot, generation)
    }

    fn into_raw_parts(self) -> (u32, u32) {
        self.into_raw_parts()
    }
}
