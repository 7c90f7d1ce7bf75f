//! The trait of a patched Rapier 0.36, whose pipelines accept any broad phase that implements it.

use super::adapter::{Input, Trial, UnisizeBroadPhase};
use super::rapier::dynamics::{IntegrationParameters, RigidBodySet};
use super::rapier::geometry::{
    Aabb, BroadPhasePairEvent, ColliderHandle, ColliderSet, CustomBroadPhase, PipelineInput,
};
use super::rapier::parry::partitioning::Bvh;
use crate::proxy_table::Lists;

/// Calls `run` with the input of a pipeline.
fn with_input(input: &PipelineInput<'_>, run: impl FnOnce(&Input<'_>)) {
    let is_active = input.narrow_phase.map(|narrow_phase| {
        |first, second| {
            // Two colliders have either a contact pair or an intersection pair.
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

/// Implements the trait; the first argument is the method for updates in a pipeline. What is left differs between the two types.
macro_rules! impl_custom_broad_phase {
    ($name:ident, $run_in_pipeline:ident, $($rest:tt)*) => {
        impl CustomBroadPhase for $name {
            fn update(
                &mut self,
                params: &IntegrationParameters,
                colliders: &ColliderSet,
                bodies: &RigidBodySet,
                modified_colliders: &[ColliderHandle],
                removed_colliders: &[ColliderHandle],
                events: &mut Vec<BroadPhasePairEvent>,
            ) {
                let (modified, removed) = (modified_colliders, removed_colliders);
                self.run(&Input::new(params, colliders, bodies, modified, removed), events);
            }

            fn update_in_pipeline(
                &mut self,
                input: &PipelineInput<'_>,
                events: &mut Vec<BroadPhasePairEvent>,
            ) {
                with_input(input, |input| self.$run_in_pipeline(input, events));
            }

            fn set_aabb(
                &mut self,
                params: &IntegrationParameters,
                handle: ColliderHandle,
                aabb: Aabb,
            ) {
                self.set_boxes(params, None, &[(handle, aabb)]);
            }

            fn set_aabbs(
                &mut self,
                params: &IntegrationParameters,
                colliders: &ColliderSet,
                aabbs: &[(ColliderHandle, Aabb)],
            ) {
                self.set_boxes(params, Some(colliders), aabbs);
            }

            fn clone_box(&self) -> Box<dyn CustomBroadPhase> {
                Box::new(self.clone())
            }

            $($rest)*
        }
    };
}

impl_custom_broad_phase! { UnisizeBroadPhase, run_in_pipeline,
    fn is_new(&self) -> bool {
        self.stats().updates == 0
    }

    fn visit_unreported(&self, visit: &mut dyn FnMut(ColliderHandle, Option<ColliderHandle>)) {
        for &(collider, neighbor) in &self.unreported {
            visit(collider, neighbor);
        }
    }

    fn bvh(&self) -> &Bvh {
        self.tree()
    }
}

impl_custom_broad_phase! { Trial, run,
    fn is_new(&self) -> bool {
        self.updates() == 0
    }

    fn bvh(&self) -> &Bvh {
        self.own().bvh()
    }
}
