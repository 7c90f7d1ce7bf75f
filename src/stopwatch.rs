//! The times of phases.

use std::time::{Duration, Instant};

/// The wall-clock time of each phase of finding pairs. Zeros unless timing is on.
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
    /// Returns the phases with their names, in the order of the work.
    pub fn by_name(&self) -> [(&'static str, Duration); 5] {
        [
            ("read", self.read),
            ("sort", self.sort),
            ("sweep", self.sweep),
            ("difference", self.difference),
            ("events", self.events),
        ]
    }

    /// Returns the sum of all phases.
    pub fn total(&self) -> Duration {
        self.by_name().iter().map(|(_, time)| time).sum()
    }
}

/// Whether there is a clock. WebAssembly without an operating system has none, and reading it would panic.
const IS_CLOCK: bool = !cfg!(all(target_family = "wasm", target_os = "unknown"));

/// The time, if there is a clock.
pub(crate) fn now() -> Option<Instant> {
    IS_CLOCK.then(Instant::now)
}

/// The time since then; zero without a clock.
pub(crate) fn since(began: Option<Instant>) -> Duration {
    began.map_or(Duration::ZERO, |began| began.elapsed())
}

/// A phase of an update, as in [`PhaseTimes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    Read,
    Sort,
    Sweep,
    Difference,
    Events,
}

/// Adds up the times of phases. Reads the clock only if it is on.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stopwatch {
    is_on: bool,
    /// The phase that is running, and its start.
    running: Option<(Phase, Instant)>,
    pub(crate) times: PhaseTimes,
}

impl Stopwatch {
    pub(crate) fn new(is_on: bool) -> Self {
        Self {
            is_on: is_on && IS_CLOCK,
            ..Self::default()
        }
    }

    /// Returns a stopwatch that is on if this one is, and starts from zero.
    pub(crate) fn reset(&self) -> Self {
        Self::new(self.is_on)
    }

    /// Begins a phase, and ends the running one, if any.
    pub(crate) fn enter(&mut self, phase: Phase) {
        if self.is_on {
            self.switch(Some(phase));
        }
    }

    /// Ends the running phase, if any.
    pub(crate) fn leave(&mut self) {
        if self.running.is_some() {
            self.switch(None);
        }
    }

    fn switch(&mut self, next: Option<Phase>) {
        let now = Instant::now();
        if let Some((phase, began)) = self.running {
            let times = &mut self.times;
            *match phase {
                Phase::Read => &mut times.read,
                Phase::Sort => &mut times.sort,
                Phase::Sweep => &mut times.sweep,
                Phase::Difference => &mut times.difference,
                Phase::Events => &mut times.events,
            } += now - began;
        }
        self.running = next.map(|phase| (phase, now));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_stopwatch_that_is_on_adds_phases_up() {
        for is_on in [false, true] {
            let mut stopwatch = Stopwatch::new(is_on);
            for phase in [Phase::Sort, Phase::Read, Phase::Sort] {
                stopwatch.enter(phase);
                std::thread::sleep(Duration::from_millis(1));
            }
            stopwatch.leave();
            let PhaseTimes { sort, read, .. } = stopwatch.times;
            assert_eq!(sort >= Duration::from_millis(2), is_on);
            assert_eq!(read >= Duration::from_millis(1), is_on);
            assert_eq!(stopwatch.times.total(), sort + read);
        }
    }
}
