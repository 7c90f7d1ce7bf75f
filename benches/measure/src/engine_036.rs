//! How Rapier 0.36 drives a broad phase: it computes and passes the boxes of moved colliders, and lists new ones. The
//! work that its own broad phase defers, to do it next to the solver, counts as a part of the next update.

use super::ours::{PairFilter, UnisizeBroadPhase};
use super::rapier::prelude::*;
use super::world::{Driven, World};
use crate::time;
use std::time::Duration;

/// The version of Rapier.
pub(crate) const RAPIER: &str = "0.36";

/// The filter levels that are measured: the default, and that of Rapier's own broad phase.
pub(crate) const LEVELS: &[PairFilter] = &[PairFilter::Shapes, PairFilter::Groups];

/// Removes a collider.
pub(crate) fn remove(handle: ColliderHandle, world: &mut World) {
    let (islands, bodies) = (&mut world.islands, &mut world.bodies);
    let soft_bodies = &mut SoftBodySet::new();
    let colliders = &mut world.colliders;
    colliders.remove(handle, islands, bodies, soft_bodies, false);
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
