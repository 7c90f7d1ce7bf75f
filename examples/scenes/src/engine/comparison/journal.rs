//! What a broad phase has told the narrow phase since the last look, in its shortest form.
//!
//! A collider's removal ends its pairs whatever was said of them before. So the removals can be played first
//! and the events after them, if what was said of a collider before its removal is struck out.

use super::rapier::prelude::*;

/// A copy of [`BroadPhasePairEvent`], which is not `Clone`.
#[derive(Clone, Copy, Debug)]
pub(super) enum Event {
    /// The pair is new.
    Add(ColliderPair),
    /// The pair has ended.
    Delete(ColliderPair),
}

impl Event {
    pub(super) fn pair(self) -> ColliderPair {
        match self {
            Self::Add(pair) | Self::Delete(pair) => pair,
        }
    }
}

impl From<&BroadPhasePairEvent> for Event {
    fn from(event: &BroadPhasePairEvent) -> Self {
        match event {
            BroadPhasePairEvent::AddPair(pair) => Self::Add(*pair),
            BroadPhasePairEvent::DeletePair(pair) => Self::Delete(*pair),
        }
    }
}

impl From<Event> for BroadPhasePairEvent {
    fn from(event: Event) -> Self {
        match event {
            Event::Add(pair) => Self::AddPair(pair),
            Event::Delete(pair) => Self::DeletePair(pair),
        }
    }
}

/// What a broad phase has told the narrow phase since the last look.
#[derive(Default)]
pub(super) struct Journal {
    /// The colliders that were removed or disabled, in order.
    pub(super) removed: Vec<ColliderHandle>,
    /// What was reported after the last removal of either collider, in order.
    pub(super) events: Vec<Event>,
}

impl Journal {
    /// Takes down one update.
    pub(super) fn record(&mut self, removed: &[ColliderHandle], events: &[BroadPhasePairEvent]) {
        if !removed.is_empty() && !self.events.is_empty() {
            let removed: std::collections::HashSet<_> = removed.iter().collect();
            self.events.retain(|event| {
                let pair = event.pair();
                !removed.contains(&pair.collider1) && !removed.contains(&pair.collider2)
            });
        }
        self.removed.extend_from_slice(removed);
        self.events.extend(events.iter().map(Event::from));
    }

    pub(super) fn clear(&mut self) {
        self.removed.clear();
        self.events.clear();
    }
}
