//! What Rapier 0.36 spells in its own way: glam's vectors, and broad phases that boxes are handed over to.

use super::scenes::OwnBroadPhase;
use super::scenes::rapier::{math, prelude::*};
use crate::finder::Cell;

pub(super) use super::scenes::BroadPhase;

pub(super) type Vector = math::Vector;
pub(super) type Point = math::Vector;
pub(super) type AngVector = math::AngVector;

/// The events of one broad phase, and the tree of Rapier's own, through which a step sweeps what is fast.
struct OnRapiersTree<B> {
    events: B,
    tree: OwnBroadPhase,
}

/// This broad phase, where a step finds the tree of Rapier's own.
pub(super) fn on_rapiers_tree<B: BroadPhase>(events: B) -> impl BroadPhase {
    let tree = OwnBroadPhase::new();
    OnRapiersTree { events, tree }
}

impl<B: BroadPhase> BroadPhase for OnRapiersTree<B> {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let unheard = &mut Vec::new();
        self.tree
            .update(params, colliders, bodies, modified, removed, unheard);
        self.events
            .update(params, colliders, bodies, modified, removed, events);
    }

    fn set_aabb(&mut self, params: &IntegrationParameters, handle: ColliderHandle, aabb: Aabb) {
        self.set_aabbs(params, &ColliderSet::new(), &[(handle, aabb)]);
    }

    fn set_aabbs(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        boxes: &[(ColliderHandle, Aabb)],
    ) {
        self.tree.set_aabbs(params, colliders, boxes);
        self.events.set_aabbs(params, colliders, boxes);
    }

    fn update_in_pipeline(
        &mut self,
        input: &PipelineInput<'_>,
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.tree.update_in_pipeline(input, &mut Vec::new());
        self.events.update_in_pipeline(input, events);
    }

    fn bvh(&self) -> &Bvh {
        self.tree.bvh()
    }

    // A copy has a tree of its own.
    fn clone_box(&self) -> Box<dyn BroadPhase> {
        self.events.clone_box()
    }
}

/// None: a step asks the tree of its broad phase, which a grid does not have.
pub(super) fn hash_grid(_: Cell) -> Option<DefaultBroadPhase> {
    None
}

/// What this version asks of a broad phase beside updates.
macro_rules! when_boxes_are_handed_over {
    ($($item:item)*) => {
        $($item)*

        fn set_aabb(
            &mut self,
            params: &IntegrationParameters,
            handle: ColliderHandle,
            aabb: Aabb,
        ) {
            self.set_aabbs(params, &ColliderSet::new(), &[(handle, aabb)]);
        }
    };
}
pub(super) use when_boxes_are_handed_over;
