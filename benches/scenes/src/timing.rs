//! The clock, and how long the updates of one broad phase took.

#[cfg(not(target_family = "wasm"))]
use cpu_time::ThreadTime;
use serde::Serialize;
#[cfg(target_family = "wasm")]
use std::time::Instant as ThreadTime;
use std::time::{Duration, Instant};

/// What times are measured by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Clock {
    /// The processor time of the thread, which other work of the machine does not lengthen.
    #[default]
    Processor,
    /// The wall clock, for work that several threads share.
    Wall,
}

/// A clock that runs.
#[derive(Clone, Copy, Debug)]
pub enum Stopwatch {
    /// The processor time at which it was started.
    Processor(ThreadTime),
    /// The moment at which it was started.
    Wall(Instant),
}

impl Clock {
    /// The clock for work on this number of threads.
    pub fn of_threads(threads: usize) -> Self {
        match threads {
            0 | 1 => Self::Processor,
            _ => Self::Wall,
        }
    }

    /// Starts the clock, on the thread that reads it.
    pub fn start(self) -> Stopwatch {
        match self {
            Self::Processor => Stopwatch::Processor(ThreadTime::now()),
            Self::Wall => Stopwatch::Wall(Instant::now()),
        }
    }
}

impl Stopwatch {
    /// The time since it was started.
    pub fn elapsed(&self) -> Duration {
        match self {
            Self::Processor(start) => start.elapsed(),
            Self::Wall(start) => start.elapsed(),
        }
    }
}

/// How long the updates of one broad phase took.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Timing {
    /// The sum over all updates.
    pub total: Duration,
    /// The first update, which inserts all colliders, if it has been made.
    first: Option<Duration>,
    /// The longest of the others.
    longest: Duration,
    last: Duration,
    /// How many others there were.
    updates: usize,
}

/// The times of one broad phase in a simulation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Times {
    /// Milliseconds of the first update, which inserts all colliders.
    pub ms_first_update: f64,
    /// Milliseconds of all other updates per step.
    pub ms_per_step: f64,
    /// Milliseconds of the longest of them.
    pub ms_worst_update: f64,
    /// The number of them.
    pub updates: usize,
}

impl Timing {
    /// Adds an update.
    pub fn record(&mut self, elapsed: Duration) {
        self.total += elapsed;
        self.last = elapsed;
        if self.first.is_none() {
            self.first = Some(elapsed);
        } else {
            self.updates += 1;
            self.longest = self.longest.max(elapsed);
        }
    }

    /// Adds the processing of boxes that were passed after an update, as a part of that update.
    pub fn record_boxes(&mut self, elapsed: Duration) {
        self.total += elapsed;
        self.last += elapsed;
        match &mut self.first {
            Some(first) if self.updates == 0 => *first += elapsed,
            _ => self.longest = self.longest.max(self.last),
        }
    }

    /// Forgets all updates. The next one does not count as the first.
    pub fn restart(&mut self) {
        *self = Self {
            first: Some(Duration::ZERO),
            ..Self::default()
        };
    }

    /// The times over this many steps.
    pub fn over(&self, steps: usize) -> Times {
        let first = self.first.unwrap_or_default();
        Times {
            ms_first_update: milliseconds(first),
            ms_per_step: milliseconds(self.total - first) / steps as f64,
            ms_worst_update: milliseconds(self.longest),
            updates: self.updates,
        }
    }
}

/// A duration in milliseconds.
pub fn milliseconds(duration: Duration) -> f64 {
    duration.as_secs_f64() * 1e3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_update_and_its_boxes_are_apart() {
        let ms = Duration::from_millis;
        let mut timing = Timing::default();
        for (update, boxes) in [(50, 5), (2, 1), (1, 4)] {
            timing.record(ms(update));
            timing.record_boxes(ms(boxes));
        }
        let times = timing.over(2);
        assert_eq!((times.ms_first_update, times.ms_worst_update), (55.0, 5.0));
        assert_eq!((times.ms_per_step, times.updates), (4.0, 2));
        timing.restart();
        timing.record(ms(7));
        let times = timing.over(1);
        assert_eq!((times.ms_worst_update, times.updates), (7.0, 1));
    }
}
