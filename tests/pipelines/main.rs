//! Whole worlds stepped with ours and with Rapier's own broad phase, side by side: `suite` in Rapier 0.27, and in `opened/tests` in the
//! own pipelines of Rapier 0.36; `only_027` in Rapier 0.27 alone.
//!
//! `Twins` steps two equal worlds and compares, after every step, what a user can
//! see: contacts, intersections, events, sleep and poses. In most worlds no body meets more than one other, so
//! that the order in which the solver gets the contacts cannot matter and everything must be the same to the
//! last bit. Where it does matter (`piles`) each world goes its own way, and what Rapier's narrow phase knows is held to what touches
//! by the shapes.
#![cfg(any(
    feature = "rapier2d-027",
    feature = "rapier3d-027",
    feature = "rapier2d-f64-027",
    feature = "rapier3d-f64-027",
))]

mod questions;
mod strategies;

macro_rules! flavour {
    ($feature:tt, $rapier:ident, $unisize:ident, $name:ident, $dim:tt) => {
        #[cfg(feature = $feature)]
        #[path = "."]
        mod $name {
            use flavour::{height_field, hinge, mesh_floor, spin};
            use unisize::$unisize::{PairFilter, Settings, Trial, UnisizeBroadPhase};
            use unisize_scenes::$name::{AnyBroadPhase, Installed, Steppable, Tee, World, install};
            use $rapier as rapier;

            #[path = $dim]
            mod flavour;
            mod only_027;
            mod suite;
            #[path = "version/rapier_027.rs"]
            mod version;
        }
    };
}

flavour!("rapier2d-027", rapier2d, rapier2d_027, dim2, "dim2/mod.rs");
flavour!("rapier3d-027", rapier3d, rapier3d_027, dim3, "dim3/mod.rs");
flavour!(
    "rapier2d-f64-027",
    rapier2d_f64,
    rapier2d_f64_027,
    dim2_f64,
    "dim2/mod.rs"
);
flavour!(
    "rapier3d-f64-027",
    rapier3d_f64,
    rapier3d_f64_027,
    dim3_f64,
    "dim3/mod.rs"
);

// It does not look into macros.
#[cfg(rustfmt)]
mod dim2;
#[cfg(rustfmt)]
mod dim3;
#[cfg(rustfmt)]
mod only_027;
#[cfg(rustfmt)]
mod suite;
#[cfg(rustfmt)]
mod version {
    mod rapier_027;
    mod rapier_036;
}
