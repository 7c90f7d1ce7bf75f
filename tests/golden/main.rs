//! The same boxes give the same events in the same order: in another run, on any number of threads, in a clone, after
//! a save, on every platform, in whatever way pairs are searched for and colliders listed, and in every version since a golden hash was taken.
//!
//! A changed hash means that the events, or their order, have changed. If that is intended, the test prints the new one for
//! `hashes.txt`.

#![cfg(feature = "_adapter")]

mod hash;
mod hashes;

#[path = "../common/flavours.rs"]
#[macro_use]
mod flavours;

#[allow(unused_macros)]
macro_rules! flavour {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt) => {
        #[path = "."]
        mod $name {
            use unisize::$unisize::{Settings, Stats, UnisizeBroadPhase};
            use $rapier as rapier;

            const FLAVOUR: &str = stringify!($name);

            mod suite;

            #[path = "../common/crowd"]
            mod versions {
                use super::rapier;

                #[path = $version]
                pub(super) mod version;
            }
            use versions::version;
        }
    };
}

for_each_027!(flavour);
for_each_036!(flavour);

// It does not look into macros.
#[cfg(rustfmt)]
mod suite;
