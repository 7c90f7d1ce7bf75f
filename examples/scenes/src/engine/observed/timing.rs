//! How long the updates of one broad phase took.

use std::time::{Duration, Instant};

/// How long the updates of one broad phase took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Timing {
    /// All updates together.
    pub total: Duration,
    /// The longest update. It is often the first, which meets every collider for the first time.
    pub worst: Duration,
    /// The last update.
    pub last: Duration,
    /// When the last update was over and what was asked for had been taken down; none before the first one.
    pub end: Option<Instant>,
    /// How many updates there were.
    pub updates: usize,
    /// How many of them had a collider to look at, modified, removed or handed over.
    pub busy_updates: usize,
    busy_total: Duration,
    /// Whether boxes were handed over since the last update, which has to look at them.
    has_boxes: bool,
}

impl Timing {
    pub(super) fn record(&mut self, elapsed: Duration, is_busy: bool) {
        self.total += elapsed;
        self.worst = self.worst.max(elapsed);
        self.last = elapsed;
        self.updates += 1;
        if is_busy | std::mem::take(&mut self.has_boxes) {
            self.busy_total += elapsed;
            self.busy_updates += 1;
        }
    }

    /// Adds what was done with the boxes that were handed over after an update, as a part of it.
    #[allow(dead_code)] // Only later versions hand over boxes.
    pub(super) fn record_boxes(&mut self, elapsed: Duration) {
        self.has_boxes = true;
        self.total += elapsed;
        self.busy_total += elapsed;
        self.last += elapsed;
        self.worst = self.worst.max(self.last);
    }

    /// The mean of the updates that had a collider to look at.
    pub fn mean_busy(&self) -> Duration {
        match u32::try_from(self.busy_updates) {
            Ok(updates) if updates > 0 => self.busy_total / updates,
            _ => Duration::ZERO,
        }
    }
}
