//! A broad phase that is timed, and the pairs that it holds.

use super::scenes::rapier::prelude::*;
use std::collections::HashSet;
use std::time::{Duration, Instant};

/// A broad phase that is timed, and the pairs that it holds by its events.
pub(super) struct Clocked {
    inner: Box<dyn BroadPhase>,
    /// The pairs held, the smaller handle first, if they are recorded.
    pub(super) held: Option<HashSet<[ColliderHandle; 2]>>,
    /// How long the last update took.
    pub(super) elapsed: Duration,
    /// When the update and the records were done: when the narrow phase began.
    pub(super) done: Instant,
}

impl Clocked {
    pub(super) fn new(inner: Box<dyn BroadPhase>, records_pairs: bool) -> Self {
        Self {
            inner,
            held: records_pairs.then(HashSet::new),
            elapsed: Duration::ZERO,
            done: Instant::now(),
        }
    }
}

/// A pair with the smaller handle first.
pub(super) fn key(a: ColliderHandle, b: ColliderHandle) -> [ColliderHandle; 2] {
    if a.into_raw_parts() <= b.into_raw_parts() {
        [a, b]
    } else {
        [b, a]
    }
}

impl BroadPhase for Clocked {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let start = Instant::now();
        let inner = &mut self.inner;
        inner.update(params, colliders, bodies, modified, removed, events);
        self.elapsed = start.elapsed();
        if let Some(held) = &mut self.held {
            for event in events {
                match event {
                    BroadPhasePairEvent::AddPair(pair) => {
                        held.insert(key(pair.collider1, pair.collider2));
                    }
                    BroadPhasePairEvent::DeletePair(pair) => {
                        held.remove(&key(pair.collider1, pair.collider2));
                    }
                }
            }
        }
        self.done = Instant::now();
    }
}
