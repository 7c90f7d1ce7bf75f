//! What times are taken by.

use cpu_time::ThreadTime;
use std::time::{Duration, Instant};

/// From so many colliders on, the processor's clock, which costs a third of a microsecond to read, disturbs nothing.
const PROCESSOR_FROM: usize = 10_000;

/// A clock of the machine or of the thread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Clock {
    /// Goes on while something else has the processor.
    Wall,
    /// Stands still meanwhile.
    Processor,
}

impl Clock {
    /// The one for updates of so many colliders.
    pub(crate) fn for_count(count: usize) -> Self {
        if count < PROCESSOR_FROM {
            Self::Wall
        } else {
            Self::Processor
        }
    }

    /// How long some work takes.
    pub(crate) fn time(self, work: impl FnOnce()) -> Duration {
        match self {
            Self::Wall => {
                let start = Instant::now();
                work();
                start.elapsed()
            }
            Self::Processor => {
                let start = ThreadTime::now();
                work();
                start.elapsed()
            }
        }
    }
}
