//! A broad phase of the user's, in the place of the tree.

use super::BroadPhaseBvh;
use crate::alloc_prelude::*;
use crate::dynamics::{IntegrationParameters, IslandManager, RigidBodySet};
use crate::geometry::{
    Aabb, BroadPhasePairEvent, ColliderChanges, ColliderHandle, ColliderSet,
};
use core::any::Any;
use parry::partitioning::Bvh;

/// A broad phase that takes the place of Rapier's own: see [`BroadPhaseBvh::custom`].
pub trait CustomBroadPhase: Any + Send + Sync {
    /// Appends the changes of the pair set to `events`: the contract of [`BroadPhaseBvh::update`].
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified_colliders: &[ColliderHandle],
        removed_colliders: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    );

    /// Sets the box of a collider, which counts as modified in the next update: the contract of [`BroadPhaseBvh::set_aabb`].
    fn set_aabb(&mut self, params: &IntegrationParameters, handle: ColliderHandle, aabb: Aabb);

    /// Sets the boxes of all colliders that a step has moved.
    fn set_aabbs(
        &mut self,
        params: &IntegrationParameters,
        _colliders: &ColliderSet,
        aabbs: &[(ColliderHandle, Aabb)],
    ) {
        for (handle, aabb) in aabbs {
            self.set_aabb(params, *handle, *aabb);
        }
    }

    /// Colliders that the last update was given, each with one whose box overlapped its own before and that was not reported as its
    /// pair, and whether it was given as removed. What has no pair with a changed collider is not woken by the narrow phase; these
    /// are woken all the same.
    fn unreported(&self) -> &[(ColliderHandle, ColliderHandle, bool)] {
        &[]
    }

    /// A tree over the boxes as they are now, for queries and CCD. Its leaves are the indices of handles.
    fn bvh(&self) -> &Bvh;

    /// The same broad phase again, for `BroadPhaseBvh::clone`.
    fn clone_box(&self) -> Box<dyn CustomBroadPhase>;
}

impl BroadPhaseBvh {
    /// A broad phase that leaves everything to `broad_phase`. The settings of Rapier's own have no effect on it.
    pub fn custom(broad_phase: impl CustomBroadPhase) -> Self {
        Self {
            custom: Custom(Some(Box::new(broad_phase))),
            ..Self::default()
        }
    }

    /// The custom broad phase, if there is one and it is a `T`.
    pub fn custom_ref<T: CustomBroadPhase>(&self) -> Option<&T> {
        let custom: &dyn Any = self.custom.0.as_deref()?;
        custom.downcast_ref()
    }

    /// The custom broad phase, if there is one and it is a `T`.
    pub fn custom_mut<T: CustomBroadPhase>(&mut self) -> Option<&mut T> {
        let custom: &mut dyn Any = self.custom.0.as_deref_mut()?;
        custom.downcast_mut()
    }

    /// [`Self::set_aabb`] for many.
    pub(crate) fn set_aabbs(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        aabbs: &[(ColliderHandle, Aabb)],
    ) {
        if let Some(custom) = &mut self.custom.0 {
            return custom.set_aabbs(params, colliders, aabbs);
        }
        for (handle, aabb) in aabbs {
            self.set_aabb(params, *handle, *aabb);
        }
    }

    /// Wakes the bodies of unreported pairs, as the narrow phase wakes those of the pairs it knows.
    pub(crate) fn wake_unreported(
        &self,
        islands: &mut IslandManager,
        bodies: &mut RigidBodySet,
        colliders: &ColliderSet,
    ) {
        let Some(custom) = &self.custom.0 else {
            return;
        };
        for &(listed, other, is_removed) in custom.unreported() {
            let has_changed = colliders.get(listed).is_some_and(|collider| {
                let unfelt = ColliderChanges::IN_MODIFIED_SET | ColliderChanges::DEFORMED;
                collider.changes.needs_narrow_phase_update() && !unfelt.contains(collider.changes)
            });
            if !(is_removed || has_changed) {
                continue;
            }
            for handle in [listed, other] {
                if let Some(parent) = colliders.get(handle).and_then(|collider| collider.parent) {
                    islands.wake_up(bodies, parent.handle, true);
                }
            }
        }
    }

    /// The tree for queries and CCD.
    pub(crate) fn bvh(&self) -> &Bvh {
        match &self.custom.0 {
            Some(custom) => custom.bvh(),
            None => &self.tree,
        }
    }
}

/// The custom broad phase of a [`BroadPhaseBvh`], if it has one.
#[derive(Default)]
pub(super) struct Custom(pub(super) Option<Box<dyn CustomBroadPhase>>);

impl Clone for Custom {
    fn clone(&self) -> Self {
        Self(self.0.as_ref().map(|custom| custom.clone_box()))
    }
}

#[cfg(feature = "serde-serialize")]
impl Custom {
    pub(super) fn none() -> Self {
        Self(None)
    }

    pub(super) fn is_none(&self) -> bool {
        self.0.is_none()
    }

    /// A snapshot that leaves the custom broad phase out would be read as one without pairs.
    pub(super) fn refuse<S: serde::Serializer>(&self, _: S) -> Result<S::Ok, S::Error> {
        Err(serde::ser::Error::custom(
            "a custom broad phase is not part of this snapshot: serialize it by itself (`custom_ref`), \
             and put it back with `BroadPhaseBvh::custom`",
        ))
    }
}
