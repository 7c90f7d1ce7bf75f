//! How Rapier 0.27 drives a broad phase: by lists of all that is new or has moved, which the broad phase reads by itself.

use super::frames::World;
use super::rapier::prelude::*;
use crate::time;
use std::time::Duration;

/// The version of Rapier.
pub(crate) const RAPIER: &str = "0.27";

/// Removes a collider.
pub(crate) fn remove(handle: ColliderHandle, islands: &mut IslandManager, world: &mut World) {
    let bodies = &mut world.bodies;
    world.colliders.remove(handle, islands, bodies, false);
}

/// A broad phase as its engine drives it.
pub(crate) trait Driven {
    /// How long an update takes of colliders that were inserted, moved, and removed since the last one.
    fn follow(
        &mut self,
        world: &mut World,
        inserted: &[ColliderHandle],
        moved: &[ColliderHandle],
        removed: &[ColliderHandle],
    ) -> Duration;
}

impl<B: BroadPhase> Driven for B {
    fn follow(
        &mut self,
        world: &mut World,
        inserted: &[ColliderHandle],
        moved: &[ColliderHandle],
        removed: &[ColliderHandle],
    ) -> Duration {
        let listed = [moved, inserted].concat();
        let (colliders, bodies) = (&world.colliders, &world.bodies);
        let (params, events) = (&world.params, &mut world.events);
        time(world.count, || {
            self.update(params, colliders, bodies, &listed, removed, events)
        })
    }
}
