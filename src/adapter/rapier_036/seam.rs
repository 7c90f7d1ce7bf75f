//! The seam of an opened Rapier 0.36: its pipelines take any broad phase that implements this trait.

use super::adapter::{Input, Trial, UnisizeBroadPhase};
use super::rapier::dynamics::{IntegrationParameters, RigidBodySet};
use super::rapier::geometry::{
    Aabb, BroadPhasePairEvent, ColliderHandle, ColliderSet, CustomBroadPhase,
};
use super::rapier::parry::partitioning::Bvh;
use crate::proxy_table::Lists;

impl CustomBroadPhase for UnisizeBroadPhase {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified_colliders: &[ColliderHandle],
        removed_colliders: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let lists = Lists::new(modified_colliders, removed_colliders);
        self.update_as_noted(&Input::new(params, colliders, bodies, lists), events);
    }

    fn note_changes(&mut self, reinserted: &[ColliderHandle], unmoved: &[ColliderHandle]) {
        self.noted.reinserted.extend_from_slice(reinserted);
        self.noted.unmoved.extend_from_slice(unmoved);
    }

    fn is_new(&self) -> bool {
        self.stats().updates == 0
    }

    fn set_aabb(&mut self, params: &IntegrationParameters, handle: ColliderHandle, aabb: Aabb) {
        self.hand_over(params, None, &[(handle, aabb)]);
    }

    fn set_aabbs(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        aabbs: &[(ColliderHandle, Aabb)],
    ) {
        self.hand_over(params, Some(colliders), aabbs);
    }

    fn unreported(&self) -> &[(ColliderHandle, ColliderHandle, bool)] {
        &self.near
    }

    fn bvh(&self) -> &Bvh {
        self.tree()
    }

    fn clone_box(&self) -> Box<dyn CustomBroadPhase> {
        Box::new(self.clone())
    }
}

impl CustomBroadPhase for Trial {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified_colliders: &[ColliderHandle],
        removed_colliders: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let lists = Lists::new(modified_colliders, removed_colliders);
        self.run(&Input::new(params, colliders, bodies, lists), events);
    }

    fn note_changes(&mut self, reinserted: &[ColliderHandle], unmoved: &[ColliderHandle]) {
        for tried in &mut self.tried {
            tried.note_changes(reinserted, unmoved);
        }
    }

    fn is_new(&self) -> bool {
        self.tried[0].is_new()
    }

    fn set_aabb(&mut self, params: &IntegrationParameters, handle: ColliderHandle, aabb: Aabb) {
        self.hand_over(params, None, &[(handle, aabb)]);
    }

    fn set_aabbs(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        aabbs: &[(ColliderHandle, Aabb)],
    ) {
        self.hand_over(params, Some(colliders), aabbs);
    }

    fn bvh(&self) -> &Bvh {
        self.own.bvh()
    }

    fn clone_box(&self) -> Box<dyn CustomBroadPhase> {
        Box::new(self.clone())
    }
}
