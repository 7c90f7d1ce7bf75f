//! How Rapier 0.27 drives a broad phase: by lists of all that is new or has moved, which the broad phase reads by itself.

use super::rapier::prelude::*;
use crate::common;
use std::time::Duration;

/// What Rapier's own broad phase is called in tables.
#[allow(dead_code, reason = "not every bench prints a name")]
pub(crate) const DEFAULT: &str = "Rapier 0.27";

/// What unisize is called beside it.
#[allow(dead_code, reason = "not every bench prints a name")]
pub(crate) const OURS: &str = "unisize for 0.27";

/// Removes a collider.
#[allow(dead_code, reason = "not every bench does")]
pub(crate) fn remove(
    handle: ColliderHandle,
    colliders: &mut ColliderSet,
    islands: &mut IslandManager,
    bodies: &mut RigidBodySet,
) {
    colliders.remove(handle, islands, bodies, false);
}

/// A broad phase as its engine drives it.
pub(crate) trait Driven {
    /// How long an update takes, after colliders were inserted, moved, and removed, in this order.
    fn follow(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        lists: [&[ColliderHandle]; 3],
        events: &mut Vec<BroadPhasePairEvent>,
    ) -> Duration;
}

impl<B: BroadPhase> Driven for B {
    fn follow(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        [inserted, moved, removed]: [&[ColliderHandle]; 3],
        events: &mut Vec<BroadPhasePairEvent>,
    ) -> Duration {
        let listed = [moved, inserted].concat();
        common::clock_for(colliders.len())
            .time(|| self.update(params, colliders, bodies, &listed, removed, events))
    }
}
