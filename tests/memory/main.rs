//! How much memory the broad phase holds, counted by this program's own allocator.
//!
//! The allocator counts the memory of all threads, so the tests take turns.

mod handles;
#[path = "../../examples/study/soak/memory.rs"]
mod memory;
mod soak;
mod trees;

use std::sync::{Mutex, MutexGuard, PoisonError};

#[path = "../../examples/study/engine"]
mod dim2 {
    use unisize::rapier2d_027 as ours;
    use unisize_scenes::dim2 as scenes;

    mod soak;
    pub(crate) use soak::Soak;
}

#[path = "../../examples/study/engine"]
mod dim3 {
    use unisize::rapier3d_027 as ours;
    use unisize_scenes::dim3 as scenes;

    mod soak;
    pub(crate) use soak::Soak;
}

/// Waits until no other test of this program is running.
fn turn() -> MutexGuard<'static, ()> {
    static TURN: Mutex<()> = Mutex::new(());
    TURN.lock().unwrap_or_else(PoisonError::into_inner)
}
