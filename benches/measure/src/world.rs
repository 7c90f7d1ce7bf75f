//! The parts of Rapier that a broad phase reads, and its events: one source, compiled once for each engine and dimension.

use super::rapier::prelude::*;
use std::time::Duration;

/// The parts of Rapier that a broad phase reads, and its events.
pub(crate) struct World {
    pub(crate) params: IntegrationParameters,
    pub(crate) islands: IslandManager,
    pub(crate) bodies: RigidBodySet,
    pub(crate) colliders: ColliderSet,
    pub(crate) events: Vec<BroadPhasePairEvent>,
    /// The number of colliders.
    pub(crate) count: usize,
}

impl World {
    /// An empty world for this many colliders.
    pub(crate) fn new(count: usize) -> Self {
        Self {
            params: IntegrationParameters::default(),
            islands: IslandManager::new(),
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            events: Vec::new(),
            count,
        }
    }
}

/// A broad phase as its engine drives it.
pub(crate) trait Driven {
    /// Returns how long an update takes, with the colliders that were inserted, moved and removed since the last one.
    fn follow(
        &mut self,
        world: &mut World,
        inserted: &[ColliderHandle],
        moved: &[ColliderHandle],
        removed: &[ColliderHandle],
    ) -> Duration;
}
