//! The worlds on which unisize is tested, measured and shown.
//!
//! `dim2`, `dim3`, `dim2_f64` and `dim3_f64` are one source, compiled once for each engine whose feature is on:
//! `rapier2d-027`, `rapier3d-027`, `rapier2d-f64-027` and `rapier3d-f64-027`. A `dim3::Scene` is built from a [`SceneKind`], a number
//! of bodies and a seed, and is stepped with any broad phase:
//!
//! ```
//! # #[cfg(feature = "rapier3d-027")]
//! # {
//! use unisize_scenes::SceneKind;
//! use unisize_scenes::dim3::{Scene, rapier::prelude::DefaultBroadPhase};
//!
//! let mut scene = Scene::build(SceneKind::FallingBalls, 100, 7);
//! let initial = scene.sanity();
//! let mut broad_phase = DefaultBroadPhase::new();
//! for _ in 0..10 {
//!     scene.step(&mut broad_phase, &(), &());
//! }
//! assert_eq!(scene.sanity().verdict(&initial), Ok(()));
//! # }
//! ```
//!
//! The folders `dim2` and `dim3` have the differences between the dimensions beyond Rapier's own aliases, and `version` has those between
//! its versions. `dim2_036` and the like are for patched copies of Rapier 0.36, and exist only with such a copy.
//! [`DriftingBoxes`], [`ConvergingBoxes`], [`HardBoxes`], [`Mixture`], [`Needles`], [`Aimed`] and [`HardFrames`] need no engine.

#[macro_use]
#[path = "../../../tests/common/boxes/mod.rs"]
mod arrangements;

mod boxes;
mod converging;
mod hard_motions;
mod kind;
mod outcome;
mod timing;

pub use arrangements::{Aimed, HardBoxes, Mixture, Needles};
pub use boxes::DriftingBoxes;
pub use converging::ConvergingBoxes;
pub use hard_motions::{HardFrames, HardMotion};
pub use kind::SceneKind;
pub use outcome::{Both, End, Limit, Outcome, Rays, Repeat, Spread, WholeSteps};
pub use timing::{Clock, Stopwatch, Times, Timing, milliseconds};

use arrangements::random;

/// The scenes for one engine: the source for all engines, the modules that differ by dimension, and the one that differs by version.
/// Only later versions have `soft`.
#[allow(unused_macros)] // Without engines.
macro_rules! flavour {
    ($name:ident = $engine:ident in $folder:literal, $version:literal $(, $soft:ident)?) => {
        #[path = $folder]
        pub mod $name {
            //! The scenes for one engine.

            pub use ::$engine as rapier;

            #[path = "../engine/mod.rs"]
            mod engine;
            mod flavour;
            $(mod $soft;)?
            mod vehicle;
            #[path = $version]
            mod version;

            pub use engine::*;
            pub use flavour::spin;
            pub use version::*;
        }
    };
}

#[cfg(feature = "rapier2d-027")]
flavour!(dim2 = rapier2d in "dim2", "../version/rapier_027.rs");
#[cfg(feature = "rapier3d-027")]
flavour!(dim3 = rapier3d in "dim3", "../version/rapier_027.rs");
#[cfg(feature = "rapier2d-f64-027")]
flavour!(dim2_f64 = rapier2d_f64 in "dim2", "../version/rapier_027.rs");
#[cfg(feature = "rapier3d-f64-027")]
flavour!(dim3_f64 = rapier3d_f64 in "dim3", "../version/rapier_027.rs");
#[cfg(all(feature = "rapier2d-036", opened_rapier2d))]
flavour!(dim2_036 = rapier2d_036 in "dim2", "../version/rapier_036.rs", soft);
#[cfg(all(feature = "rapier3d-036", opened_rapier3d))]
flavour!(dim3_036 = rapier3d_036 in "dim3", "../version/rapier_036.rs", soft);
#[cfg(all(feature = "rapier2d-f64-036", opened_rapier2d_f64))]
flavour!(dim2_f64_036 = rapier2d_f64_036 in "dim2", "../version/rapier_036.rs", soft);
#[cfg(all(feature = "rapier3d-f64-036", opened_rapier3d_f64))]
flavour!(dim3_f64_036 = rapier3d_f64_036 in "dim3", "../version/rapier_036.rs", soft);

// rustfmt does not look into macros.
#[cfg(rustfmt)]
mod engine;
#[cfg(rustfmt)]
mod dim2 {
    mod flavour;
    mod soft;
    mod vehicle;
}
#[cfg(rustfmt)]
mod dim3 {
    mod flavour;
    mod soft;
    mod vehicle;
}
#[cfg(rustfmt)]
mod version {
    mod rapier_027;
    mod rapier_036;
}
