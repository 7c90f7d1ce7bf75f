//! What a broad phase has told the narrow phase since the last check, in its shortest form.
//!
//! A collider's removal ends its pairs, whatever was reported of them before. So the removals can be played first
//! and the events after them, once the events of a collider from before its removal are struck out.

use super::rapier::prelude::*;
use super::{PairEvent, Update};

/// What a broad phase has told the narrow phase since the last check.
#[derive(Default)]
pub(super) struct Journal {
    /// The colliders that were removed or disabled, in order.
    pub(super) removed: Vec<ColliderHandle>,
    /// What was reported after the last removal of either collider, in order.
    pub(super) events: Vec<PairEvent>,
}

impl Journal {
    /// Records one update.
    pub(super) fn record(&mut self, update: &Update) {
        if !update.removed.is_empty() && !self.events.is_empty() {
            let removed: std::collections::HashSet<_> = update.removed.iter().collect();
            self.events.retain(|event| {
                let pair = event.pair();
                !removed.contains(&pair.collider1) && !removed.contains(&pair.collider2)
            });
        }
        self.removed.extend_from_slice(&update.removed);
        self.events.extend_from_slice(&update.events);
    }

    pub(super) fn clear(&mut self) {
        self.removed.clear();
        self.events.clear();
    }
}
