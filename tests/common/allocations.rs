//! How much memory the program holds, counted by its allocator.

use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// The bytes that are allocated at this moment.
pub(crate) fn live_bytes() -> usize {
    let stats = ALLOCATOR.stats();
    stats.bytes_allocated.wrapping_sub(stats.bytes_deallocated)
}

/// The bytes that have been allocated so far, freed or not.
#[allow(dead_code)] // The study does not ask.
pub(crate) fn allocated_bytes() -> usize {
    ALLOCATOR.stats().bytes_allocated
}

/// How often a list of the program has been moved or resized so far.
#[allow(dead_code)] // The study does not ask.
pub(crate) fn reallocations() -> usize {
    ALLOCATOR.stats().reallocations
}

/// The peak numbers of bytes held, early in a run and later.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Peaks {
    pub(crate) early: usize,
    pub(crate) late: usize,
}

impl Peaks {
    /// Notes what is held after `done` of `all` updates. The first tenth of them counts as early.
    pub(crate) fn note(&mut self, done: u64, all: u64) {
        let peak = if done <= all / 10 {
            &mut self.early
        } else {
            &mut self.late
        };
        *peak = live_bytes().max(*peak);
    }

    /// Whether at most half as much memory again was held later than early on: buffers keep the size of the largest
    /// crowd so far, and a larger one may always come.
    pub(crate) fn are_flat(&self) -> bool {
        self.late <= self.early + self.early / 2
    }
}
