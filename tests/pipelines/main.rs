//! Whole worlds stepped with ours and with Rapier's own broad phase, side by side: `suite` in Rapier 0.27, and in `examples/opened/tests` in the
//! own pipelines of Rapier 0.36; `only_027` in Rapier 0.27 alone. `published` is about Rapier 0.36 that is not opened.
//!
//! `Twins` steps two equal worlds and compares, after every step, what a user can
//! see: contacts, intersections, events, sleep and poses. In most worlds no body meets more than one other, so
//! that the order in which the solver gets the contacts cannot matter and everything must be the same to the
//! last bit. Where it does matter (`piles`) each world goes its own way, and what Rapier's narrow phase knows is held to what touches
//! by the shapes.
#![cfg(feature = "_adapter")]

#[path = "../flavours/mod.rs"]
#[macro_use]
mod flavours;

#[allow(unused_macros)]
macro_rules! flavour {
    ($name:ident, $rapier:ident, $unisize:ident, $dim:tt, $version:tt) => {
        #[path = "."]
        mod $name {
            use flavour::{height_field, hinge, mesh_floor, spin};
            use unisize::$unisize::{PairFilter, Settings, Trial, UnisizeBroadPhase};
            use unisize_scenes::$name::{AnyBroadPhase, Installed, Steppable, World, install};
            use $rapier as rapier;

            #[path = $dim]
            mod flavour;
            mod only_027;
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

            mod published;
        }
    };
}

for_each_027!(flavour);
for_each_036!(published);

// It does not look into macros.
#[cfg(rustfmt)]
mod dim2;
#[cfg(rustfmt)]
#[path = "dim3.rs"]
mod dim3;
#[cfg(rustfmt)]
mod only_027;
#[cfg(rustfmt)]
mod published;
#[cfg(rustfmt)]
mod rapier_027;
#[cfg(rustfmt)]
mod rapier_036;
#[cfg(rustfmt)]
mod suite;
#[cfg(rustfmt)]
mod vehicles;
