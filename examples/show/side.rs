//! A broad phase that is timed, and whose pairs are recorded where that is wanted.

use super::rapier::prelude::*;
use std::collections::BTreeSet;
use std::time::{Duration, Instant};

/// A pair of colliders as indices and generations, the smaller first.
pub(super) type Pair = [(u32, u32); 2];

/// A broad phase with the pairs that it has reported.
pub(super) struct Side<B> {
    pub(super) broad_phase: B,
    /// The pairs by its events, if they are recorded.
    pub(super) held: Option<BTreeSet<Pair>>,
    pub(super) events: Vec<BroadPhasePairEvent>,
    pub(super) elapsed: Duration,
}

impl<B: BroadPhase> Side<B> {
    pub(super) fn new(broad_phase: B, records: bool) -> Self {
        Self {
            broad_phase,
            held: records.then(BTreeSet::new),
            events: Vec::new(),
            elapsed: Duration::ZERO,
        }
    }

    pub(super) fn pairs(&self) -> Vec<ColliderPair> {
        let held = self.held.iter().flatten();
        held.map(|pair| {
            let [first, second] =
                pair.map(|(index, generation)| ColliderHandle::from_raw_parts(index, generation));
            ColliderPair::new(first, second)
        })
        .collect()
    }

    /// Updates the broad phase and leaves its events in `events`.
    pub(super) fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
    ) {
        self.events.clear();
        let start = Instant::now();
        self.broad_phase.update(
            params,
            colliders,
            bodies,
            modified,
            removed,
            &mut self.events,
        );
        self.elapsed += start.elapsed();
        let Some(held) = &mut self.held else {
            return;
        };
        if !removed.is_empty() {
            let removed: BTreeSet<_> = removed
                .iter()
                .map(|handle| handle.into_raw_parts())
                .collect();
            held.retain(|pair| !pair.iter().any(|collider| removed.contains(collider)));
        }
        for event in &self.events {
            match *event {
                BroadPhasePairEvent::AddPair(added) => held.insert(pair(added)),
                BroadPhasePairEvent::DeletePair(deleted) => held.remove(&pair(deleted)),
            };
        }
    }
}

pub(super) fn pair(pair: ColliderPair) -> Pair {
    let (first, second) = (
        pair.collider1.into_raw_parts(),
        pair.collider2.into_raw_parts(),
    );
    [first.min(second), first.max(second)]
}
