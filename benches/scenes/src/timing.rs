//! How long the updates of one broad phase took.

use serde::Serialize;
use std::time::Duration;

/// How long the updates of one broad phase took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Timing {
    /// All updates together.
    pub total: Duration,
    /// The longest update. It is often the first, which meets every collider for the first time.
    worst: Duration,
    last: Duration,
    updates: usize,
    busy_total: Duration,
    busy_updates: usize,
    /// Whether boxes were handed over since the last update, which has to look at them.
    has_boxes: bool,
}

/// The times of one broad phase in a simulation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Times {
    /// Milliseconds of all updates, for each step.
    pub ms_per_step: f64,
    /// The mean of the updates that had a collider to look at, modified, removed or handed over.
    pub ms_per_busy_update: f64,
    /// The longest update.
    pub ms_worst_update: f64,
    /// How many updates there were.
    pub updates: usize,
    /// How many of them had a collider to look at.
    pub busy_updates: usize,
}

impl Timing {
    /// Adds an update, which is busy if it had a collider to look at.
    pub fn record(&mut self, elapsed: Duration, is_busy: bool) {
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
    pub fn record_boxes(&mut self, elapsed: Duration) {
        self.has_boxes = true;
        self.total += elapsed;
        self.busy_total += elapsed;
        self.last += elapsed;
        self.worst = self.worst.max(self.last);
    }

    /// The times of so many steps.
    pub fn over(&self, steps: usize) -> Times {
        Times {
            ms_per_step: milliseconds(self.total) / steps as f64,
            ms_per_busy_update: milliseconds(self.busy_total) / self.busy_updates.max(1) as f64,
            ms_worst_update: milliseconds(self.worst),
            updates: self.updates,
            busy_updates: self.busy_updates,
        }
    }
}

/// A duration in milliseconds.
pub fn milliseconds(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e3
}
