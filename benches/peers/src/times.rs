//! The times of many frames, and what is reported of them.

use std::time::Duration;

/// How long each of some frames took.
#[derive(Default)]
pub(crate) struct Times(Vec<Duration>);

impl Times {
    pub(crate) fn push(&mut self, time: Duration) {
        self.0.push(time);
    }

    pub(crate) fn count(&self) -> usize {
        self.0.len()
    }

    /// In milliseconds; 0 if there are no frames.
    pub(crate) fn mean(&self) -> f64 {
        let sum: Duration = self.0.iter().sum();
        milliseconds(sum) / self.0.len().max(1) as f64
    }

    /// In milliseconds; 0 if there are no frames.
    pub(crate) fn median(&self) -> f64 {
        let mut sorted = self.0.clone();
        sorted.sort_unstable();
        sorted
            .get(sorted.len() / 2)
            .map_or(0.0, |&time| milliseconds(time))
    }

    /// In milliseconds; 0 if there are no frames.
    pub(crate) fn worst(&self) -> f64 {
        self.0.iter().max().map_or(0.0, |&time| milliseconds(time))
    }
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
