//! How Rapier 0.36 drives a broad phase: it hands over the boxes of what it has moved, which it computes for any broad phase,
//! and lists what is new.

use super::ours::UnisizeBroadPhase;
use super::rapier::prelude::*;
use crate::common;
use std::time::Duration;

/// What Rapier's own broad phase is called in tables.
#[allow(dead_code, reason = "not every bench prints a name")]
pub(crate) const DEFAULT: &str = "Rapier 0.36";

/// What unisize is called beside it.
#[allow(dead_code, reason = "not every bench prints a name")]
pub(crate) const OURS: &str = "unisize for 0.36";

/// Removes a collider.
#[allow(dead_code, reason = "not every bench does")]
pub(crate) fn remove(
    handle: ColliderHandle,
    colliders: &mut ColliderSet,
    islands: &mut IslandManager,
    bodies: &mut RigidBodySet,
) {
    colliders.remove(handle, islands, bodies, &mut SoftBodySet::new(), false);
}

/// A broad phase as its engine drives it.
pub(crate) trait Driven {
    /// How long an update takes, after colliders were inserted, moved, and removed, in this order. What Rapier's own defers,
    /// to do it beside the solver, counts as a part of the next update.
    fn follow(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        [inserted, moved, removed]: [&[ColliderHandle]; 3],
        events: &mut Vec<BroadPhasePairEvent>,
    ) -> Duration {
        let box_of = |&handle: &ColliderHandle| {
            let aabb = colliders[handle].compute_broad_phase_aabb(params, bodies);
            (handle, aabb)
        };
        let boxes: Vec<_> = moved.iter().map(box_of).collect();
        common::clock_for(colliders.len()).time(|| {
            self.take(params, &boxes);
            self.update_with(params, colliders, bodies, [inserted, removed], events);
        })
    }

    /// Takes the boxes of what was moved.
    fn take(&mut self, params: &IntegrationParameters, boxes: &[(ColliderHandle, Aabb)]);

    /// Learns of what was inserted and removed, and reports how pairs have changed.
    fn update_with(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        lists: [&[ColliderHandle]; 2],
        events: &mut Vec<BroadPhasePairEvent>,
    );
}

impl Driven for UnisizeBroadPhase {
    fn take(&mut self, params: &IntegrationParameters, boxes: &[(ColliderHandle, Aabb)]) {
        self.set_aabbs(params, boxes);
    }

    fn update_with(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        [inserted, removed]: [&[ColliderHandle]; 2],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.update(params, colliders, bodies, inserted, removed, events);
    }
}

impl Driven for DefaultBroadPhase {
    fn take(&mut self, params: &IntegrationParameters, boxes: &[(ColliderHandle, Aabb)]) {
        for (handle, aabb) in boxes {
            self.set_aabb(params, *handle, *aabb);
        }
    }

    fn update_with(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        [inserted, removed]: [&[ColliderHandle]; 2],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.update(params, colliders, bodies, inserted, removed, events);
    }
}
