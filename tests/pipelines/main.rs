//! Whole worlds stepped with ours and with Rapier's own broad phase, side by side: `suite` in Rapier 0.27, and in `examples/opened/tests` in the
//! own pipelines of Rapier 0.36. `published` is about Rapier 0.36 that is not opened, `by_hand` about both.
//!
//! `Twins` steps two equal worlds and compares, after every step, what a user can
//! see: contacts, intersections, events, sleep and poses. No body meets more than one other that moves, so
//! that the order in which the solver gets the contacts cannot matter and everything must be the same to the
//! last bit. Piles and all else that `examples/scenes` has are compared by `tests/scenes.rs`.
#![cfg(feature = "_adapter")]

#[path = "../cases/mod.rs"]
mod cases;
#[path = "../flavours/mod.rs"]
#[macro_use]
mod flavours;

#[allow(unused_macros)]
macro_rules! flavour {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt) => {
        #[path = "."]
        mod $name {
            use flavour::{hinge, mesh_floor, spin};
            use unisize::$unisize::{PairFilter, Settings, Trial, UnisizeBroadPhase};
            use unisize_scenes::$name::{
                AnyBroadPhase, Installed, Observed, OwnBroadPhase, Steppable, World, install,
            };
            use $rapier as rapier;

            mod by_hand;
            mod exchange;
            #[path = $dim]
            mod flavour;
            mod suite;
            #[path = $version]
            mod version;
        }
    };
}

#[allow(unused_macros)]
macro_rules! published {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt) => {
        #[path = "."]
        mod $name {
            use unisize::$unisize::{PairFilter, Settings, UnisizeBroadPhase};
            use $rapier as rapier;

            mod by_hand;
            mod published;
        }
    };
}

for_each_027!(flavour);
for_each_036!(published);

// It does not look into macros.
#[cfg(rustfmt)]
mod by_hand;
#[cfg(rustfmt)]
mod dim2;
#[cfg(rustfmt)]
mod dim3;
#[cfg(rustfmt)]
mod exchange;
#[cfg(rustfmt)]
mod published;
#[cfg(rustfmt)]
mod rapier_027;
#[cfg(rustfmt)]
mod rapier_036;
#[cfg(rustfmt)]
mod suite;
