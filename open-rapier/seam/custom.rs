//! A broad phase of the user's, in the place of the tree.

use super::BroadPhaseBvh;
use crate::alloc_prelude::*;
use crate::dynamics::{IntegrationParameters, IslandManager, RigidBodySet};
use crate::geometry::{
    Aabb, BroadPhasePairEvent, ColliderChanges, ColliderHandle, ColliderPair, ColliderSet, NarrowPhase,
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

    /// Tells, just before an update, which of the modified colliders are `reinserted`: their groups, body, or its type or dominance have
    /// changed, so they get new boxes, without a margin. And which were listed and are not among the modified colliders, `unmoved` ones: what
    /// has changed about them does not count for a broad phase, so their boxes stay, whatever their contact skin is now.
    fn note_changes(&mut self, _reinserted: &[ColliderHandle], _unmoved: &[ColliderHandle]) {}

    /// Whether it has never been updated, and so knows no colliders. A pipeline then hands over the boxes of all that are there, and ends
    /// the pairs of its narrow phase that the update does not report.
    fn is_new(&self) -> bool {
        false
    }

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
            custom: Custom::with(Some(Box::new(broad_phase))),
            ..Self::default()
        }
    }

    /// The custom broad phase, if there is one and it is a `T`.
    pub fn custom_ref<T: CustomBroadPhase>(&self) -> Option<&T> {
        let custom: &dyn Any = self.custom.broad_phase.as_deref()?;
        custom.downcast_ref()
    }

    /// The custom broad phase, if there is one and it is a `T`.
    pub fn custom_mut<T: CustomBroadPhase>(&mut self) -> Option<&mut T> {
        let custom: &mut dyn Any = self.custom.broad_phase.as_deref_mut()?;
        custom.downcast_mut()
    }

    /// [`Self::set_aabb`] for many.
    pub(crate) fn set_aabbs(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        aabbs: &[(ColliderHandle, Aabb)],
    ) {
        if let Some(custom) = &mut self.custom.broad_phase {
            return custom.set_aabbs(params, colliders, aabbs);
        }
        for (handle, aabb) in aabbs {
            self.set_aabb(params, *handle, *aabb);
        }
    }

    /// [`Self::update`] in a pipeline. A broad phase that is new in a running world, because it was exchanged or read from a save, learns of
    /// the colliders that have not changed, and pairs that only the one before it has reported end.
    pub(crate) fn update_in_pipeline(
        &mut self,
        narrow_phase: &NarrowPhase,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified_colliders: &[ColliderHandle],
        removed_colliders: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let is_new = match &self.custom.broad_phase {
            Some(custom) => custom.is_new(),
            None => self.frame_index == 0 && self.tree.is_empty(),
        };
        let is_listed = |handle: &&ColliderHandle| colliders.contains(**handle);
        let is_exchanged =
            is_new && modified_colliders.iter().filter(is_listed).count() < colliders.len();
        if is_exchanged {
            for (handle, collider) in colliders.iter() {
                let is_unlisted = !collider.changes.contains(ColliderChanges::IN_MODIFIED_SET);
                if collider.is_enabled() && is_unlisted {
                    let aabb = collider.compute_broad_phase_aabb(params, bodies);
                    if aabb.mins.is_finite() && aabb.maxs.is_finite() {
                        self.set_aabb(params, handle, aabb);
                    }
                }
            }
        }
        self.update(
            params,
            colliders,
            bodies,
            modified_colliders,
            removed_colliders,
            events,
        );
        if is_exchanged {
            end_unreported(narrow_phase, colliders, events);
        }
    }

    /// Wakes the bodies of unreported pairs, as the narrow phase wakes those of the pairs it knows.
    pub(crate) fn wake_unreported(
        &self,
        islands: &mut IslandManager,
        bodies: &mut RigidBodySet,
        colliders: &ColliderSet,
    ) {
        let Some(custom) = &self.custom.broad_phase else {
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
    pub fn bvh(&self) -> &Bvh {
        match &self.custom.broad_phase {
            Some(custom) => custom.bvh(),
            None => &self.tree,
        }
    }
}

/// The custom broad phase of a [`BroadPhaseBvh`], if it has one.
#[derive(Default)]
pub(super) struct Custom {
    pub(super) broad_phase: Option<Box<dyn CustomBroadPhase>>,
    /// Scratch: the lists of an update; see [`CustomBroadPhase::note_changes`].
    modified: Vec<ColliderHandle>,
    reinserted: Vec<ColliderHandle>,
    unmoved: Vec<ColliderHandle>,
}

impl Clone for Custom {
    fn clone(&self) -> Self {
        let broad_phase = self.broad_phase.as_ref();
        Self::with(broad_phase.map(|custom| custom.clone_box()))
    }
}

impl Custom {
    pub(super) fn with(broad_phase: Option<Box<dyn CustomBroadPhase>>) -> Self {
        Self {
            broad_phase,
            modified: Vec::new(),
            reinserted: Vec::new(),
            unmoved: Vec::new(),
        }
    }

    /// Updates the custom broad phase with the colliders that Rapier's own would look at, and says whether there is one.
    pub(super) fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) -> bool {
        let Some(custom) = &mut self.broad_phase else {
            return false;
        };
        let lists = [&mut self.modified, &mut self.reinserted, &mut self.unmoved];
        lists.into_iter().for_each(Vec::clear);
        let reinserting = ColliderChanges::PARENT
            | ColliderChanges::PARENT_EFFECTIVE_DOMINANCE
            | ColliderChanges::GROUPS;
        for &handle in modified {
            let changes = colliders.get(handle).map(|collider| collider.changes);
            let is_reinserted = changes.is_some_and(|changes| changes.intersects(reinserting));
            if is_reinserted {
                self.reinserted.push(handle);
            }
            match changes {
                Some(changes) if !(is_reinserted || changes.needs_broad_phase_update()) => {
                    self.unmoved.push(handle)
                }
                _ => self.modified.push(handle),
            }
        }
        custom.note_changes(&self.reinserted, &self.unmoved);
        custom.update(params, colliders, bodies, &self.modified, removed, events);
        true
    }
}

/// Ends the pairs of a narrow phase that are not among `events`.
fn end_unreported(
    narrow_phase: &NarrowPhase,
    colliders: &ColliderSet,
    events: &mut Vec<BroadPhasePairEvent>,
) {
    let key = |a: ColliderHandle, b: ColliderHandle| {
        let mut key = [a.into_raw_parts(), b.into_raw_parts()];
        key.sort_unstable();
        key
    };
    let added = events.iter().filter_map(|event| match event {
        BroadPhasePairEvent::AddPair(pair) => Some(key(pair.collider1, pair.collider2)),
        BroadPhasePairEvent::DeletePair(_) => None,
    });
    let mut reported: Vec<_> = added.collect();
    reported.sort_unstable();
    let contacts = narrow_phase.contact_pairs();
    let contacts = contacts.map(|pair| (pair.collider1, pair.collider2));
    let intersections = narrow_phase.intersection_pairs();
    let pairs = contacts.chain(intersections.map(|(a, b, _)| (a, b)));
    for (a, b) in pairs {
        let are_there = colliders.contains(a) && colliders.contains(b);
        if are_there && reported.binary_search(&key(a, b)).is_err() {
            events.push(BroadPhasePairEvent::DeletePair(ColliderPair::new(a, b)));
        }
    }
}
