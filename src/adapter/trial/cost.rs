//! The time and memory of a broad phase on trial.

use std::time::Duration;

use super::super::rapier::geometry::BroadPhasePairEvent;
use super::Measured;
use crate::pair_filter::PairFilter;
use crate::stopwatch;

/// The time and memory of a broad phase so far.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Cost {
    /// The time of the current update.
    current: Duration,
    total: Duration,
    longest: Duration,
    /// The sum of the pairs after each update.
    pairs: u64,
    bytes: Option<i64>,
}

impl Cost {
    /// Runs a part of the current update, and adds its time and memory. The memory of events does not count.
    pub(super) fn of(
        &mut self,
        allocated: Option<fn() -> usize>,
        events: &mut Vec<BroadPhasePairEvent>,
        run: impl FnOnce(&mut Vec<BroadPhasePairEvent>),
    ) {
        let bytes = |events: &Vec<BroadPhasePairEvent>| {
            let of_events = events.capacity() * size_of::<BroadPhasePairEvent>();
            allocated.map(|allocated| allocated() as i64 - of_events as i64)
        };
        let before = bytes(events);
        let began = stopwatch::now();
        run(events);
        self.current += stopwatch::since(began);
        if let (Some(before), Some(after)) = (before, bytes(events)) {
            *self.bytes.get_or_insert(0) += after - before;
        }
    }

    /// Ends an update, after which there are this many pairs. `update` counts from 1, and is `None` if there was nothing to read.
    pub(super) fn end_update(&mut self, update: Option<u64>, pairs: usize) {
        let time = std::mem::take(&mut self.current);
        self.total += time;
        self.pairs += update.map_or(0, |_| pairs as u64);
        if update > Some(1) {
            self.longest = self.longest.max(time);
        }
    }

    pub(super) fn measured(&self, level: Option<PairFilter>, updates: u64) -> Measured {
        let updates = updates.max(1) as f64;
        Measured {
            level,
            total: self.total,
            mean: self.total.div_f64(updates),
            longest: self.longest,
            pairs: self.pairs as f64 / updates,
            bytes: self.bytes,
        }
    }
}
