//! How much memory the broad phase holds, counted by an allocator of this program's own.
//!
//! It counts what all threads hold, so the tests take turns.

#[path = "../../examples/soak/dim2.rs"]
mod dim2;
#[path = "../../examples/soak/dim3.rs"]
mod dim3;
mod handles;
#[path = "../../examples/soak/memory.rs"]
mod memory;
mod soak;
mod trees;

use std::sync::{Mutex, MutexGuard, PoisonError};

/// Waits until no other test of this program is running.
fn turn() -> MutexGuard<'static, ()> {
    static TURN: Mutex<()> = Mutex::new(());
    TURN.lock().unwrap_or_else(PoisonError::into_inner)
}
