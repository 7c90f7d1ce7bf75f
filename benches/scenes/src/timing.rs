//! How long the updates of one broad phase took.

use serde::Serialize;
use std::time::Duration;

/// How long the updates of one broad phase took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Timing {
    /// The sum over all updates.
    pub total: Duration,
    /// The longest update. It is often the first one, which reads every collider for the first time.
    worst: Duration,
    last: Duration,
    updates: usize,
}

/// The times of one broad phase in a simulation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Times {
    /// Milliseconds of all updates per step.
    pub ms_per_step: f64,
    /// Milliseconds of the longest update.
    pub ms_worst_update: f64,
    /// The number of updates.
    pub updates: usize,
}

impl Timing {
    /// Adds an update.
    pub fn record(&mut self, elapsed: Duration) {
        self.total += elapsed;
        self.worst = self.worst.max(elapsed);
        self.last = elapsed;
        self.updates += 1;
    }

    /// Adds the processing of boxes that were passed after an update, as a part of that update.
    pub fn record_boxes(&mut self, elapsed: Duration) {
        self.total += elapsed;
        self.last += elapsed;
        self.worst = self.worst.max(self.last);
    }

    /// The times over this many steps.
    pub fn over(&self, steps: usize) -> Times {
        Times {
            ms_per_step: milliseconds(self.total) / steps as f64,
            ms_worst_update: milliseconds(self.worst),
            updates: self.updates,
        }
    }
}

/// A duration in milliseconds.
pub fn milliseconds(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e3
}
