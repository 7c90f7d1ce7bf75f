//! Rapier's own collision pipeline, to compare with.

use std::sync::mpsc::channel;

use rapier3d_036::prelude::*;

use crate::beads::Beads;

/// Beads in the same places, under Rapier's own broad and narrow phase.
#[derive(Default)]
pub(crate) struct Engine {
    colliders: ColliderSet,
    broad_phase: DefaultBroadPhase,
    narrow_phase: NarrowPhase,
}

impl Engine {
    pub(crate) fn new(beads: &Beads) -> Self {
        Self {
            colliders: beads.colliders.clone(),
            ..Self::default()
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
        let (sender, events) = channel();
        CollisionPipeline::new().step(
            params.prediction_distance(),
            &mut IslandManager::new(),
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut RigidBodySet::new(),
            &mut self.colliders,
            &(),
            &ChannelEventCollector::new(sender, channel().0, channel().0),
        );
        events.try_iter().collect()
    }
}
