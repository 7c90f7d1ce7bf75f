//! The set of pairs that the events of a broad phase amount to.

use super::super::rapier::prelude::*;
use super::PairEvent;
use std::collections::HashSet;

/// The set of pairs that the events of a broad phase amount to.
#[derive(Default)]
pub(super) struct Held {
    /// The pairs, each as it was reported.
    pub(super) pairs: HashSet<ColliderPair>,
    /// The first event that contradicts those before it.
    pub(super) fault: Option<PairEvent>,
}

impl Held {
    /// Follows one update.
    pub(super) fn follow(&mut self, removed: &[ColliderHandle], events: &[BroadPhasePairEvent]) {
        if !removed.is_empty() {
            // The pairs of what is removed end without an event.
            let removed: HashSet<_> = removed.iter().collect();
            self.pairs.retain(|pair| {
                !removed.contains(&pair.collider1) && !removed.contains(&pair.collider2)
            });
        }
        for event in events.iter().map(PairEvent::from) {
            let is_change = match event {
                PairEvent::Add(pair) => self.pairs.insert(pair),
                PairEvent::Delete(pair) => self.pairs.remove(&pair),
            };
            if !is_change {
                self.fault.get_or_insert(event);
            }
        }
    }
}
