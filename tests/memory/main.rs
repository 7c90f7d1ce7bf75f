//! How much memory the broad phase holds, counted by this program's own allocator.
//!
//! The allocator counts the memory of all threads, so the tests take turns.
#![cfg(feature = "_adapter")]

#[allow(dead_code)] // Without an engine there is nothing to count.
#[path = "../../examples/study/soak/memory.rs"]
mod memory;

#[path = "../flavours/mod.rs"]
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

/// A short run of the study `soak`: many updates of worlds in which everything changes, in the same memory.
///
/// The study makes a million: `cargo run --release --all-features --example study -- soak`.
#[path = "."]
mod soak {
    #[allow(unused_macros)]
    macro_rules! soak {
        ($name:ident, $unisize:ident) => {
            #[path = "../../examples/study/engine"]
            mod $name {
                use unisize::$unisize as ours;
                use unisize_scenes::$name as scenes;

                mod soak;

                #[test]
                fn memory_does_not_grow() {
                    const UPDATES: u64 = 20_000;
                    let _turn = crate::turn();
                    let mut soak = soak::Soak::new(200, 7);
                    let mut peaks = crate::memory::Peaks::default();
                    for done in 1..=UPDATES {
                        soak.update();
                        peaks.note(done, UPDATES);
                        if done % 50 == 0 {
                            soak.check();
                        }
                    }
                    assert!(soak.pairs() > 0);
                    assert!(peaks.are_flat(), "{peaks:?}");
                }
            }
        };
    }

    #[cfg(feature = "rapier2d-027")]
    soak!(dim2, rapier2d_027);
    #[cfg(feature = "rapier3d-027")]
    soak!(dim3, rapier3d_027);
}

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
