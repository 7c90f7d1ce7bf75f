//! How Rapier 0.36 drives a broad phase: it hands over the boxes of what it has moved, which it computes for any broad phase,
//! and lists what is new.

use super::frames::World;
use super::ours::UnisizeBroadPhase;
use super::rapier::prelude::*;
use crate::time;
use std::time::Duration;

/// The version of Rapier.
pub(crate) const RAPIER: &str = "0.36";

/// Removes a collider.
pub(crate) fn remove(handle: ColliderHandle, islands: &mut IslandManager, world: &mut World) {
    let (bodies, soft_bodies) = (&mut world.bodies, &mut SoftBodySet::new());
    let colliders = &mut world.colliders;
    colliders.remove(handle, islands, bodies, soft_bodies, false);
}

/// A broad phase as its engine drives it.
pub(crate) trait Driven {
    /// How long an update takes of colliders that were inserted, moved, and removed since the last one. What Rapier's
    /// own defers, to do it beside the solver, counts as a part of the next update.
    fn follow(
        &mut self,
        world: &mut World,
        inserted: &[ColliderHandle],
        moved: &[ColliderHandle],
        removed: &[ColliderHandle],
    ) -> Duration;
}

macro_rules! driven {
    ($broad_phase:ty, $set_boxes:expr) => {
        impl Driven for $broad_phase {
            fn follow(
                &mut self,
                world: &mut World,
                inserted: &[ColliderHandle],
                moved: &[ColliderHandle],
                removed: &[ColliderHandle],
            ) -> Duration {
                let (params, bodies) = (&world.params, &world.bodies);
                let colliders = &world.colliders;
                let box_of = |&handle: &ColliderHandle| {
                    let aabb = colliders[handle].compute_broad_phase_aabb(params, bodies);
                    (handle, aabb)
                };
                let boxes: Vec<_> = moved.iter().map(box_of).collect();
                let events = &mut world.events;
                time(world.count, || {
                    $set_boxes(self, params, &boxes);
                    self.update(params, colliders, bodies, inserted, removed, events);
                })
            }
        }
    };
}

driven!(UnisizeBroadPhase, UnisizeBroadPhase::set_aabbs);
driven!(
    DefaultBroadPhase,
    |tree: &mut DefaultBroadPhase, params: &_, boxes: &[(ColliderHandle, Aabb)]| {
        for (handle, aabb) in boxes {
            tree.set_aabb(params, *handle, *aabb);
        }
    }
);
