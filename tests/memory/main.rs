//! The memory of the broad phase, counted by the allocator of this program.
//!
//! The allocator counts the memory of all threads, so the tests run one at a time.
#![cfg(feature = "_adapter")]

#[allow(dead_code)] // Without an engine no test uses it.
#[path = "../common/allocations.rs"]
mod allocations;

#[path = "../common/flavours.rs"]
#[macro_use]
mod flavours;

use std::sync::{Mutex, MutexGuard, PoisonError};

#[allow(unused_macros)]
macro_rules! flavour {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt) => {
        #[path = "."]
        mod $name {
            use unisize::$unisize::{PairFilter, Settings, UnisizeBroadPhase};
            use $rapier as rapier;

            mod suite;
        }
    };
}

for_each_027!(flavour);
for_each_036!(flavour);

mod slabs;

/// Waits until no other test of this program runs.
#[allow(dead_code)] // Without an engine no test uses it.
fn turn() -> MutexGuard<'static, ()> {
    static TURN: Mutex<()> = Mutex::new(());
    TURN.lock().unwrap_or_else(PoisonError::into_inner)
}

// rustfmt does not look into macros.
#[cfg(rustfmt)]
mod suite;
