//! The memory of the program, counted by its allocator.

use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// The number of allocated bytes that are not freed.
pub(crate) fn live_bytes() -> usize {
    let stats = ALLOCATOR.stats();
    stats.bytes_allocated.wrapping_sub(stats.bytes_deallocated)
}

/// The number of bytes allocated so far, freed or not.
#[allow(dead_code)] // The study does not use it.
pub(crate) fn allocated_bytes() -> usize {
    ALLOCATOR.stats().bytes_allocated
}

/// The number of reallocations so far.
#[allow(dead_code)] // The study does not use it.
pub(crate) fn reallocations() -> usize {
    ALLOCATOR.stats().reallocations
}

/// The largest numbers of live bytes, early in a run and later.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Peaks {
    pub(crate) early: usize,
    pub(crate) late: usize,
}

impl Peaks {
    /// Records the live bytes after `done` of `all` updates. The first tenth of the updates counts as early.
    pub(crate) fn note(&mut self, done: u64, all: u64) {
        let peak = if done <= all / 10 {
            &mut self.early
        } else {
            &mut self.late
        };
        *peak = live_bytes().max(*peak);
    }

    /// Whether memory grew by at most half. Buffers keep the size of the largest crowd so far, and a later crowd may be larger.
    pub(crate) fn are_flat(&self) -> bool {
        self.late <= self.early + self.early / 2
    }
}
