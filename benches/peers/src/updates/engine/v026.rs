//! Rapier 0.26, the last version whose default broad phase is a sweep and prune, in regions.

use super::frames::{Changes, World};
use super::rapier::prelude::*;
use std::time::Duration;

/// A broad phase as its engine drives it.
pub(crate) trait Driven {
    /// How long an update takes.
    fn follow(&mut self, world: &mut World, changes: Changes<'_>) -> Duration;
}

/// The broad phase, which remembers its events in a pipeline that keeps them to itself.
#[derive(Default)]
pub(super) struct Recorder {
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
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let inner = &mut self.broad_phase;
        inner.update(
            dt,
            prediction_distance,
            colliders,
            bodies,
            modified,
            removed,
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

impl Driven for Recorder {
    fn follow(&mut self, world: &mut World, changes: Changes<'_>) -> Duration {
        let (colliders, bodies) = (&mut world.colliders, &mut world.bodies);
        let prediction = world.params.prediction_distance();
        if !changes.inserted.is_empty() {
            // Clears the flags of change, so that what moves later has only moved.
            let narrow_phase = &mut NarrowPhase::new();
            let mut pipeline = CollisionPipeline::new();
            pipeline.step(
                prediction,
                self,
                narrow_phase,
                bodies,
                colliders,
                None,
                &(),
                &(),
            );
            world.events.append(&mut self.events);
            return Duration::ZERO;
        }
        let (dt, events) = (world.params.dt, &mut world.events);
        let (inner, moved, removed) = (&mut self.broad_phase, changes.moved, changes.removed);
        world
            .clock
            .time(|| inner.update(dt, prediction, colliders, bodies, moved, removed, events))
    }
}
