//! How much memory the broad phase holds, counted by this program's own allocator.
//!
//! The allocator counts the memory of all threads, so the tests take turns.
#![cfg(feature = "_adapter")]

#[allow(dead_code)] // Without an engine there is nothing to count.
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

/// Waits until no other test of this program is running.
#[allow(dead_code)] // Without an engine there is nothing to wait for.
fn turn() -> MutexGuard<'static, ()> {
    static TURN: Mutex<()> = Mutex::new(());
    TURN.lock().unwrap_or_else(PoisonError::into_inner)
}

// It does not look into macros.
#[cfg(rustfmt)]
mod suite;
