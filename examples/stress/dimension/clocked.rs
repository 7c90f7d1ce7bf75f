//! A broad phase whose calls are timed one by one, by the processor time of the thread. `version` implements the engine's trait.

use cpu_time::ThreadTime;
use std::time::Duration;

/// A broad phase whose calls are timed one by one.
pub(in super::super) struct Clocked<B> {
    pub(in super::super) inner: B,
    /// The calls since they were last taken: of a step, the first one is the update that hears of what the user has changed.
    laps: Vec<Duration>,
}

impl<B> Clocked<B> {
    pub(super) fn new(inner: B) -> Self {
        Self {
            inner,
            laps: Vec::new(),
        }
    }

    pub(in super::super) fn time<T>(&mut self, work: impl FnOnce(&mut B) -> T) -> T {
        let start = ThreadTime::now();
        let result = work(&mut self.inner);
        self.laps.push(start.elapsed());
        result
    }

    /// How long the first call took since this was last asked, and all others, in milliseconds.
    pub(super) fn take_laps(&mut self) -> [f64; 2] {
        let mut laps = self.laps.drain(..).map(|lap| lap.as_secs_f64() * 1e3);
        [laps.next().unwrap_or(0.0), laps.sum()]
    }
}
