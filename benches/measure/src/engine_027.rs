//! How Rapier 0.27 drives a broad phase: it lists the colliders that are new or have moved, and the broad phase reads them.

use super::ours::PairFilter;
use super::rapier::prelude::*;
use super::world::{Driven, World};
use crate::time;
use std::time::Duration;

/// The version of Rapier.
pub(crate) const RAPIER: &str = "0.27";

/// The filter levels that are measured: the default, which is that of Rapier's own broad phase.
pub(crate) const LEVELS: &[PairFilter] = &[PairFilter::Off];

/// Removes a collider.
pub(crate) fn remove(handle: ColliderHandle, world: &mut World) {
    let (islands, bodies) = (&mut world.islands, &mut world.bodies);
    world.colliders.remove(handle, islands, bodies, false);
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
