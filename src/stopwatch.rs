//! Where the time goes.

use core::ops::AddAssign;
use std::time::{Duration, Instant};

/// How long each phase of finding pairs has taken, in wall-clock time. Zero unless it was asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
#[non_exhaustive]
pub struct PhaseTimes {
    /// Reading and checking boxes; in an update, computing them from colliders.
    pub read: Duration,
    /// Placing boxes into tubes and sorting them.
    pub sort: Duration,
    /// Comparing boxes that are near each other in that order, or looking some up in it.
    pub sweep: Duration,
    /// Finding out how the set of pairs has changed.
    pub difference: Duration,
    /// Writing the changes as events.
    pub events: Duration,
}

impl PhaseTimes {
    /// The phases by name, in the order of the work.
    pub fn by_name(&self) -> [(&'static str, Duration); 5] {
        let Self {
            read,
            sort,
            sweep,
            difference,
            events,
        } = *self;
        [
            ("read", read),
            ("sort", sort),
            ("sweep", sweep),
            ("difference", difference),
            ("events", events),
        ]
    }

    /// All phases together.
    pub fn total(&self) -> Duration {
        self.by_name().iter().map(|(_, time)| time).sum()
    }
}

impl AddAssign for PhaseTimes {
    fn add_assign(&mut self, other: Self) {
        self.read += other.read;
        self.sort += other.sort;
        self.sweep += other.sweep;
        self.difference += other.difference;
        self.events += other.events;
    }
}

/// Whether there is a clock: in WebAssembly without a system to ask there is none, and to read it would be a panic.
const IS_CLOCK: bool = !cfg!(all(target_family = "wasm", target_os = "unknown"));

/// Adds up the time that phases take. It does not read the clock unless it is switched on.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stopwatch {
    is_on: bool,
    pub(crate) times: PhaseTimes,
}

/// When a phase began, if the stopwatch is on.
#[derive(Clone, Copy)]
pub(crate) struct Lap(Option<Instant>);

impl Stopwatch {
    pub(crate) fn new(is_on: bool) -> Self {
        Self {
            is_on: is_on && IS_CLOCK,
            times: PhaseTimes::default(),
        }
    }

    /// One that is on if this one is, and starts from zero.
    pub(crate) fn reset(&self) -> Self {
        Self::new(self.is_on)
    }

    /// Begins the first phase.
    pub(crate) fn start(&self) -> Lap {
        Lap(self.is_on.then(Instant::now))
    }

    /// Ends a phase, and begins the next one.
    pub(crate) fn lap(
        &mut self,
        Lap(began): Lap,
        phase: impl FnOnce(&mut PhaseTimes) -> &mut Duration,
    ) -> Lap {
        Lap(began.map(|began| {
            let now = Instant::now();
            *phase(&mut self.times) += now - began;
            now
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_stopwatch_that_is_on_adds_laps_up() {
        for is_on in [false, true] {
            let mut stopwatch = Stopwatch::new(is_on);
            let mut lap = stopwatch.start();
            for _ in 0..2 {
                std::thread::sleep(Duration::from_millis(1));
                lap = stopwatch.lap(lap, |times| &mut times.sort);
            }
            let PhaseTimes { sort, .. } = stopwatch.times;
            assert_eq!(sort >= Duration::from_millis(2), is_on);
            assert_eq!(stopwatch.times.total(), sort);
        }
    }
}
