//! Whole worlds of Rapier 0.27 stepped with ours and with Rapier's own broad phase, side by side. `suite` is also that of
//! `benches/patched/twins`, in the own pipelines of Rapier 0.36.
//!
//! `Twins` steps two equal worlds and compares, after every step, what a user can
//! see: contacts, intersections, events, sleep and poses. No body meets more than one other that moves, so
//! that the order in which the solver gets the contacts cannot matter and everything must be the same to the
//! last bit. Piles and all else that `benches/scenes` has are compared by `all_scenes`.

#[path = "../../../../tests/common/cases.rs"]
mod cases;
#[path = "../../../../tests/common/flavours.rs"]
#[macro_use]
mod flavours;
#[cfg(feature = "enhanced-determinism")]
#[path = "../../../../tests/golden/hash.rs"]
mod hash;
#[cfg(feature = "enhanced-determinism")]
#[path = "../../../../tests/golden/hashes.rs"]
mod hashes;

#[allow(unused_macros)]
macro_rules! flavour {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt) => {
        #[path = "."]
        mod $name {
            use flavour::{hinge, mesh_floor};
            use unisize::$unisize::{PairFilter, Settings, Trial, UnisizeBroadPhase};
            use unisize_scenes::$name as scenes;
            use unisize_scenes::$name::{
                Installed, Observed, OwnBroadPhase, Steppable, World, install,
            };
            use $rapier as rapier;

            #[cfg(feature = "enhanced-determinism")]
            const FLAVOUR: &str = stringify!($name);

            mod all_scenes;
            mod exchange;
            #[path = $dim]
            mod flavour;
            #[cfg(feature = "enhanced-determinism")]
            mod golden;
            mod snapshots;
            mod suite;
            #[path = $version]
            mod version;
        }
    };
}

for_each_027!(flavour);

// It does not look into macros.
#[cfg(rustfmt)]
mod all_scenes;
#[cfg(rustfmt)]
mod dim2;
#[cfg(rustfmt)]
mod dim3;
#[cfg(rustfmt)]
mod exchange;
#[cfg(rustfmt)]
mod golden;
#[cfg(rustfmt)]
mod rapier_027;
#[cfg(rustfmt)]
mod rapier_036;
#[cfg(rustfmt)]
mod snapshots;
#[cfg(rustfmt)]
mod suite;
