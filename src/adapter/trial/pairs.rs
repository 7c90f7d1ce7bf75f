//! Which pairs a broad phase holds, by its events.

use std::collections::{BTreeSet, HashSet};

use super::super::rapier::geometry::{BroadPhasePairEvent, ColliderHandle, ColliderPair};

/// Index and generation of two colliders, in order.
pub(super) type Pair = [(u32, u32); 2];

/// The pairs that began and have not ended.
#[derive(Clone, Default)]
pub(super) struct HeldPairs(pub(super) BTreeSet<Pair>);

impl HeldPairs {
    /// Takes events. A pair may begin that is held already, as with Rapier's own.
    pub(super) fn note(&mut self, events: &[BroadPhasePairEvent]) {
        for event in events {
            match event {
                BroadPhasePairEvent::AddPair(pair) => self.0.insert(raw(pair)),
                BroadPhasePairEvent::DeletePair(pair) => self.0.remove(&raw(pair)),
            };
        }
    }

    /// Ends the pairs of what was removed, of which no event tells.
    pub(super) fn forget(&mut self, removed: &[ColliderHandle]) {
        if !removed.is_empty() {
            let removed = removed.iter().map(|handle| handle.into_raw_parts());
            let removed: HashSet<_> = removed.collect();
            self.0
                .retain(|pair| pair.iter().all(|collider| !removed.contains(collider)));
        }
    }
}

fn raw(pair: &ColliderPair) -> Pair {
    let mut pair = [pair.collider1, pair.collider2].map(|handle| handle.into_raw_parts());
    pair.sort_unstable();
    pair
}
