//! Rapier 0.26, the last version whose default broad phase is a sweep and prune, in regions.

use super::rapier::prelude::*;
use super::world::{BroadPhaseOfEngine, Driven, World};
use crate::updates::{MULTI_SAP as NAME, OURS, peer::Entry};

pub(crate) const MULTI_SAP: Entry<DIM> = Entry {
    name: NAME,
    ours: OURS,
    create: |start| Box::new(Driven::new(Recorder::default(), start)),
    // It takes minutes to put large boxes into its regions.
    takes_large: false,
};

/// The broad phase, which remembers its events in a pipeline that keeps them to itself.
#[derive(Default)]
struct Recorder {
    broad_phase: BroadPhaseMultiSap,
    events: Vec<BroadPhasePairEvent>,
}

impl BroadPhase for Recorder {
    fn update(
        &mut self,
        dt: Real,
        prediction_distance: Real,
        colliders: &mut ColliderSet,
        bodies: &RigidBodySet,
        modified_colliders: &[ColliderHandle],
        removed_colliders: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.broad_phase.update(
            dt,
            prediction_distance,
            colliders,
            bodies,
            modified_colliders,
            removed_colliders,
            events,
        );
        // Events cannot be cloned in this version.
        let copy = |event: &BroadPhasePairEvent| match *event {
            BroadPhasePairEvent::AddPair(pair) => BroadPhasePairEvent::AddPair(pair),
            BroadPhasePairEvent::DeletePair(pair) => BroadPhasePairEvent::DeletePair(pair),
        };
        self.events.extend(events.iter().map(copy));
    }
}

impl BroadPhaseOfEngine for Recorder {
    fn introduce(&mut self, world: &mut World) {
        // Clears the flags of change, so that what moves later has only moved.
        CollisionPipeline::new().step(
            world.params.prediction_distance(),
            self,
            &mut NarrowPhase::new(),
            &mut world.bodies,
            &mut world.colliders,
            None,
            &(),
            &(),
        );
        world.events.append(&mut self.events);
    }

    fn update(&mut self, world: &mut World) {
        self.broad_phase.update(
            world.params.dt,
            world.params.prediction_distance(),
            &mut world.colliders,
            &world.bodies,
            &world.listed,
            &[],
            &mut world.events,
        );
    }
}
