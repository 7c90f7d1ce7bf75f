//! Colliders and a broad phase that is updated with handwritten lists, in any version of Rapier. The module that includes it imports the engine
//! as `rapier`.

use super::rapier::prelude::*;
use super::{Settings, UnisizeBroadPhase};

/// Whether a pair begins, and its two colliders.
pub(crate) type Event = (bool, [ColliderHandle; 2]);

/// Colliders, and a broad phase that receives lists of them.
#[derive(Default)]
pub(crate) struct Desk {
    pub(crate) colliders: ColliderSet,
    pub(crate) bodies: RigidBodySet,
    pub(crate) params: IntegrationParameters,
    pub(crate) broad_phase: UnisizeBroadPhase,
}

impl Desk {
    pub(crate) fn with_settings(settings: Settings) -> Self {
        Self {
            broad_phase: UnisizeBroadPhase::with_settings(settings),
            ..Self::default()
        }
    }

    /// Inserts a ball with its centre in the xy plane. It has no body, so it counts as fixed; its collision types allow all pairs.
    pub(crate) fn ball(&mut self, radius: Real, centre: [Real; 2]) -> ColliderHandle {
        let types = ActiveCollisionTypes::all();
        let ball = ColliderBuilder::ball(radius).active_collision_types(types);
        let handle = self.colliders.insert(ball);
        self.place(handle, centre);
        handle
    }

    pub(crate) fn place(&mut self, handle: ColliderHandle, centre: [Real; 2]) {
        let mut coordinates = [0.0; DIM];
        coordinates[..2].copy_from_slice(&centre);
        self.colliders[handle].set_translation(coordinates.into());
    }

    pub(crate) fn update(
        &mut self,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
    ) -> Vec<Event> {
        let mut events = Vec::new();
        self.broad_phase.update(
            &self.params,
            &self.colliders,
            &self.bodies,
            modified,
            removed,
            &mut events,
        );
        self.broad_phase.validate();
        let events = events.iter().map(|event| match event {
            BroadPhasePairEvent::AddPair(pair) => (true, [pair.collider1, pair.collider2]),
            BroadPhasePairEvent::DeletePair(pair) => (false, [pair.collider1, pair.collider2]),
        });
        events.collect()
    }

    /// The numbers of proxies, of refused colliders, and of pairs.
    pub(crate) fn counts(&self) -> [usize; 3] {
        let stats = self.broad_phase.stats();
        [stats.proxies, stats.refused, stats.pairs]
    }
}
