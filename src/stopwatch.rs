//! Where the time goes.

use std::time::{Duration, Instant};

use crate::parallel;

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
    /// Of all that, what several threads share, or would if there were several.
    #[doc(hidden)]
    pub shared: Shared,
}

/// What several threads can share.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
#[non_exhaustive]
pub struct Shared {
    pub time: Duration,
    /// Into how many sections it is cut, at the end of each of which threads wait for each other.
    pub sections: u32,
}

impl Shared {
    pub(crate) const NONE: Self = Self {
        time: Duration::ZERO,
        sections: 0,
    };

    /// Adds what was shared between two counts of the same thread.
    pub(crate) fn add(&mut self, [before, after]: [Self; 2]) {
        self.time += after.time - before.time;
        self.sections += after.sections - before.sections;
    }
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
            shared: _,
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

/// Whether there is a clock: in WebAssembly without a system to ask there is none, and to read it would be a panic.
const IS_CLOCK: bool = !cfg!(all(target_family = "wasm", target_os = "unknown"));

/// The time, if there is a clock.
pub(crate) fn now() -> Option<Instant> {
    IS_CLOCK.then(Instant::now)
}

/// How long it is since then; zero without a clock.
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

/// Adds up the time that phases take. It does not read the clock unless it is switched on.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stopwatch {
    is_on: bool,
    /// The phase that is running, and when it began.
    running: Option<(Phase, Instant)>,
    pub(crate) times: PhaseTimes,
}

impl Stopwatch {
    pub(crate) fn new(is_on: bool) -> Self {
        if is_on {
            parallel::time_sections();
        }
        Self {
            is_on: is_on && IS_CLOCK,
            ..Self::default()
        }
    }

    /// One that is on if this one is, and starts from zero.
    pub(crate) fn reset(&self) -> Self {
        Self::new(self.is_on)
    }

    /// Begins a phase, and ends the one that is running, if any.
    pub(crate) fn enter(&mut self, phase: Phase) {
        if self.is_on {
            let now = Instant::now();
            self.end_at(now);
            self.running = Some((phase, now));
        }
    }

    /// Ends the phase that is running, if any.
    pub(crate) fn leave(&mut self) {
        if self.running.is_some() {
            self.end_at(Instant::now());
        }
    }

    fn end_at(&mut self, now: Instant) {
        let Some((phase, began)) = self.running.take() else {
            return;
        };
        let times = &mut self.times;
        *match phase {
            Phase::Read => &mut times.read,
            Phase::Sort => &mut times.sort,
            Phase::Sweep => &mut times.sweep,
            Phase::Difference => &mut times.difference,
            Phase::Events => &mut times.events,
        } += now - began;
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
