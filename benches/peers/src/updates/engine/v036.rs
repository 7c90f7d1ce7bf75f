//! Rapier 0.36, whose pipeline sets the boxes of what the solver has moved, one by one, and then updates with
//! lists of what the user has changed, which are empty here.

use super::rapier::prelude::*;
use super::world::{BroadPhaseOfEngine, Driven, World};
use crate::updates::peer::Entry;

pub(crate) const BVH: Entry<DIM> = Entry {
    name: "Rapier 0.36, BVH",
    create: |start| Box::new(Driven::new(BroadPhaseBvh::new(), start)),
    takes_large: true,
};

impl BroadPhaseOfEngine for BroadPhaseBvh {
    fn introduce(&mut self, world: &mut World) {
        // New colliders are changes by the user. This once, all the flags of change are set that the list calls
        // for; afterwards they would stay set, and would make the update insert anew what has only moved.
        BroadPhaseBvh::update(
            self,
            &world.params,
            &world.colliders,
            &world.bodies,
            &world.listed,
            &[],
            &mut world.events,
        );
    }

    fn update(&mut self, world: &mut World) {
        // The same loosening as in the pipeline, which has the body at hand and no need to look it up.
        let distance = world.params.prediction_distance() / 2.0;
        for &handle in &world.listed {
            let aabb = world.colliders[handle].compute_collision_aabb(distance);
            self.set_aabb(&world.params, handle, aabb);
        }
        BroadPhaseBvh::update(
            self,
            &world.params,
            &world.colliders,
            &world.bodies,
            &[],
            &[],
            &mut world.events,
        );
    }
}
