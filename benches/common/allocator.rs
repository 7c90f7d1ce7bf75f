//! What is allocated, counted.

use stats_alloc::{INSTRUMENTED_SYSTEM, StatsAlloc};
use std::alloc::System;

#[global_allocator]
static ALLOCATOR: &StatsAlloc<System> = &INSTRUMENTED_SYSTEM;

/// The bytes that dropping a value frees.
pub(crate) fn bytes_held<T>(thing: T) -> usize {
    let before = ALLOCATOR.stats();
    drop(thing);
    let freed = ALLOCATOR.stats() - before;
    freed.bytes_deallocated - freed.bytes_allocated
}
