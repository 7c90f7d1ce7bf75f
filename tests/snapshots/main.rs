//! A broad phase that is saved in the middle of a simulation and restored goes on as if nothing had happened: the same
//! events in the same order. And malformed snapshots do no harm.

#![cfg(feature = "serde-serialize")]

mod boxes;

#[path = "../common/flavours.rs"]
#[macro_use]
mod flavours;

#[allow(unused_macros)]
macro_rules! flavour {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt) => {
        #[path = "."]
        mod $name {
            use unisize::$unisize::{PairFilter, Settings, Stats, UnisizeBroadPhase};
            use $rapier as rapier;

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
