//! The worlds that unisize is tested, measured and shown on.
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
//! assert_eq!(scene.sanity_verdict(&initial), Ok(()));
//! # }
//! ```
//!
//! What differs between the dimensions beyond Rapier's own aliases is in the two `flavour` modules, and what differs between
//! its versions in `version/`. `dim2_036` and the like are for opened copies of Rapier 0.36, and exist if there are such.
//! [`DriftingBoxes`], [`ConvergingBoxes`], [`Stampede`], [`HardBoxes`] and [`HardFrames`] need no engine.

mod converging;
mod hard_boxes;
mod hard_motions;
mod kind;
mod random;
mod stampede;

pub mod boxes;

pub use boxes::DriftingBoxes;
pub use converging::ConvergingBoxes;
pub use hard_boxes::HardBoxes;
pub use hard_motions::{HardFrames, HardMotion};
pub use kind::SceneKind;
pub use stampede::Stampede;

#[cfg(feature = "rapier2d-027")]
pub mod dim2 {
    //! The scenes for rapier2d.

    pub use rapier2d as rapier;

    #[path = "../engine/mod.rs"]
    mod engine;
    mod flavour;
    mod vehicle;
    #[path = "../version/rapier_027.rs"]
    mod version;

    pub use engine::*;
    pub use version::*;
}

#[cfg(feature = "rapier3d-027")]
pub mod dim3 {
    //! The scenes for rapier3d.

    pub use rapier3d as rapier;

    #[path = "../engine/mod.rs"]
    mod engine;
    mod flavour;
    mod vehicle;
    #[path = "../version/rapier_027.rs"]
    mod version;

    pub use engine::*;
    pub use version::*;
}

#[cfg(feature = "rapier2d-f64-027")]
#[path = "dim2"]
pub mod dim2_f64 {
    //! The scenes for rapier2d-f64.

    pub use rapier2d_f64 as rapier;

    #[path = "../engine/mod.rs"]
    mod engine;
    mod flavour;
    mod vehicle;
    #[path = "../version/rapier_027.rs"]
    mod version;

    pub use engine::*;
    pub use version::*;
}

#[cfg(feature = "rapier3d-f64-027")]
#[path = "dim3"]
pub mod dim3_f64 {
    //! The scenes for rapier3d-f64.

    pub use rapier3d_f64 as rapier;

    #[path = "../engine/mod.rs"]
    mod engine;
    mod flavour;
    mod vehicle;
    #[path = "../version/rapier_027.rs"]
    mod version;

    pub use engine::*;
    pub use version::*;
}

#[cfg(all(feature = "rapier2d-036", opened_rapier2d))]
#[path = "dim2"]
pub mod dim2_036 {
    //! The scenes for an opened rapier2d 0.36.

    pub use rapier2d_036 as rapier;

    #[path = "../engine/mod.rs"]
    mod engine;
    mod flavour;
    mod soft;
    mod vehicle;
    #[path = "../version/rapier_036.rs"]
    mod version;

    pub use engine::*;
    pub use version::*;
}

#[cfg(all(feature = "rapier3d-036", opened_rapier3d))]
#[path = "dim3"]
pub mod dim3_036 {
    //! The scenes for an opened rapier3d 0.36.

    pub use rapier3d_036 as rapier;

    #[path = "../engine/mod.rs"]
    mod engine;
    mod flavour;
    mod soft;
    mod vehicle;
    #[path = "../version/rapier_036.rs"]
    mod version;

    pub use engine::*;
    pub use version::*;
}

#[cfg(all(feature = "rapier2d-f64-036", opened_rapier2d_f64))]
#[path = "dim2"]
pub mod dim2_f64_036 {
    //! The scenes for an opened rapier2d-f64 0.36.

    pub use rapier2d_f64_036 as rapier;

    #[path = "../engine/mod.rs"]
    mod engine;
    mod flavour;
    mod soft;
    mod vehicle;
    #[path = "../version/rapier_036.rs"]
    mod version;

    pub use engine::*;
    pub use version::*;
}

#[cfg(all(feature = "rapier3d-f64-036", opened_rapier3d_f64))]
#[path = "dim3"]
pub mod dim3_f64_036 {
    //! The scenes for an opened rapier3d-f64 0.36.

    pub use rapier3d_f64_036 as rapier;

    #[path = "../engine/mod.rs"]
    mod engine;
    mod flavour;
    mod soft;
    mod vehicle;
    #[path = "../version/rapier_036.rs"]
    mod version;

    pub use engine::*;
    pub use version::*;
}
