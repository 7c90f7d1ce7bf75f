//! Rapier's own collision pipeline, to compare with.

use std::sync::mpsc::{Receiver, channel};

use rapier3d_036::prelude::*;

use crate::beads::Beads;

/// Beads in the same places, under Rapier's own broad and narrow phase.
pub(crate) struct Engine {
    colliders: ColliderSet,
    bodies: RigidBodySet,
    islands: IslandManager,
    broad_phase: DefaultBroadPhase,
    narrow_phase: NarrowPhase,
    pipeline: CollisionPipeline,
    collector: ChannelEventCollector,
    events: Receiver<CollisionEvent>,
}

impl Engine {
    pub(crate) fn new(beads: &Beads) -> Self {
        let (sender, events) = channel();
        Self {
            colliders: beads.colliders.clone(),
            bodies: RigidBodySet::new(),
            islands: IslandManager::new(),
            broad_phase: DefaultBroadPhase::new(),
            narrow_phase: NarrowPhase::new(),
            pipeline: CollisionPipeline::new(),
            collector: ChannelEventCollector::new(sender, channel().0, channel().0),
            events,
        }
    }

    /// Puts the beads in their places and returns Rapier's events.
    pub(crate) fn step(
        &mut self,
        beads: &Beads,
        params: &IntegrationParameters,
    ) -> Vec<CollisionEvent> {
        for &handle in &beads.handles {
            let place = beads.colliders[handle].translation();
            self.colliders[handle].set_translation(place);
        }
        self.pipeline.step(
            params.prediction_distance(),
            &mut self.islands,
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &(),
            &self.collector,
        );
        self.events.try_iter().collect()
    }
}
