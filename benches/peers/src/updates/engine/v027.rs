//! Rapier 0.27, where the broad phase is a trait that its own hierarchy and unisize implement alike.

use super::ours::UnisizeBroadPhase;
use super::rapier::prelude::*;
use super::world::{BroadPhaseOfEngine, Driven, World};
use crate::updates::{self, peer::Entry};

pub(crate) const OURS: Entry<DIM> = Entry {
    name: updates::OURS,
    ours: updates::OURS,
    create: |start| Box::new(Driven::new(UnisizeBroadPhase::new(), start)),
    takes_large: true,
};

pub(crate) const DEFAULT: Entry<DIM> = Entry {
    name: updates::BVH_027,
    ours: updates::OURS,
    create: |start| Box::new(Driven::new(DefaultBroadPhase::new(), start)),
    takes_large: true,
};

impl<B: BroadPhase> BroadPhaseOfEngine for B {
    fn introduce(&mut self, world: &mut World) {
        BroadPhaseOfEngine::update(self, world);
    }

    fn update(&mut self, world: &mut World) {
        BroadPhase::update(
            self,
            &world.params,
            &world.colliders,
            &world.bodies,
            &world.listed,
            &[],
            &mut world.events,
        );
    }
}
