//! The seam of a patched Rapier 0.36: its pipelines take any broad phase that implements this trait.

use super::adapter::{Input, Trial, UnisizeBroadPhase};
use super::rapier::dynamics::{IntegrationParameters, RigidBodySet};
use super::rapier::geometry::{
    Aabb, BroadPhasePairEvent, ColliderHandle, ColliderSet, CustomBroadPhase, PipelineInput,
};
use super::rapier::parry::partitioning::Bvh;
use crate::proxy_table::Lists;

/// Calls `run` with what a pipeline gives.
fn with_input(input: &PipelineInput<'_>, run: impl FnOnce(&Input<'_>)) {
    let is_active = input.narrow_phase.map(|narrow_phase| {
        |first, second| {
            // It has one or the other.
            match narrow_phase.contact_pair(first, second) {
                Some(pair) => pair.has_any_active_contact(),
                None => narrow_phase.intersection_pair(first, second) == Some(true),
            }
        }
    });
    run(&Input {
        params: input.params,
        colliders: input.colliders,
        bodies: input.bodies,
        lists: Lists {
            modified: input.modified,
            reinserted: input.reinserted,
            unmoved: input.unmoved,
            swept: input.swept,
            removed: input.removed,
        },
        felt: input.felt,
        is_active: is_active.as_ref().map(|is_active| is_active as _),
    });
}

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
        self.bring_up_to_date(&Input::new(params, colliders, bodies, lists), events);
    }

    fn update_in_pipeline(
        &mut self,
        input: &PipelineInput<'_>,
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        with_input(input, |input| Self::update_in_pipeline(self, input, events));
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

    fn visit_unreported(&self, visit: &mut dyn FnMut(ColliderHandle, Option<ColliderHandle>)) {
        for &(collider, neighbor) in &self.unreported {
            visit(collider, neighbor);
        }
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

    fn update_in_pipeline(
        &mut self,
        input: &PipelineInput<'_>,
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        with_input(input, |input| self.run(input, events));
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
