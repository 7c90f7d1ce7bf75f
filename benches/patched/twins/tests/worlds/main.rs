//! Rapier 0.36's own pipelines, with ours in the place of its broad phase and with its own, side by side: the suite of
//! `benches/twins`, and `only_036`.
//!
//! With `--features parallel` Rapier uses its threads, with `--features unisize-parallel` ours does. `--no-default-features` leaves out
//! the engines of double precision, which take minutes to compile.

#[path = "../../../../../tests/common/cases.rs"]
mod cases;

macro_rules! flavour {
    ($rapier:ident, $unisize:ident, $name:ident, $dim:tt) => {
        #[path = "."]
        mod $name {
            use flavour::{hinge, mesh_floor};
            use unisize::$unisize::{PairFilter, Settings, Trial, UnisizeBroadPhase};
            use unisize_scenes::$name as scenes;
            use unisize_scenes::$name::{
                Installed, Observed, OwnBroadPhase, Steppable, World, install,
            };
            use $rapier as rapier;

            #[path = $dim]
            mod flavour;
            mod only_036;
            #[path = "../../../../twins/tests/worlds/suite/mod.rs"]
            mod suite;
            #[path = "../../../../twins/tests/worlds/rapier_036.rs"]
            mod version;
        }
    };
}

flavour! { rapier2d, rapier2d_036, dim2_036, "../../../../twins/tests/worlds/dim2.rs" }
flavour! { rapier3d, rapier3d_036, dim3_036, "../../../../twins/tests/worlds/dim3.rs" }
#[cfg(feature = "f64")]
flavour! { rapier2d_f64, rapier2d_f64_036, dim2_f64_036, "../../../../twins/tests/worlds/dim2.rs" }
#[cfg(feature = "f64")]
flavour! { rapier3d_f64, rapier3d_f64_036, dim3_f64_036, "../../../../twins/tests/worlds/dim3.rs" }

// It does not look into macros.
#[cfg(rustfmt)]
mod only_036;
