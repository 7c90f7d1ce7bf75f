//! The worlds that unisize is tested, measured and shown on.
//!
//! [`dim2`] and [`dim3`] are one source, compiled once against rapier2d and once against rapier3d, and so are
//! [`dim2_f64`] and [`dim3_f64`] against the engines with numbers of 64 bits. A [`dim3::Scene`] is built from a [`SceneKind`], a number of bodies and a seed, and is stepped with any
//! broad phase:
//!
//! ```
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
//! ```
//!
//! Worlds to look at, such as `dim3::Ropes` and `dim2::Gorge`, implement `Show`: they also know how they are drawn.
//!
//! What differs between the dimensions beyond Rapier's own aliases is in the two `flavour` modules.
//! [`DriftingBoxes`], [`ConvergingBoxes`], [`Backbone`], [`Stampede`], [`HardBoxes`] and [`HardFrames`] need no engine.

mod backbone;
mod converging;
mod hard_boxes;
mod hard_motions;
mod kind;
mod random;
mod stampede;

pub mod boxes;
pub mod dim2;
#[cfg(feature = "f64")]
pub mod dim2_f64;
pub mod dim3;
#[cfg(feature = "f64")]
pub mod dim3_f64;

pub use backbone::Backbone;
pub use boxes::DriftingBoxes;
pub use converging::ConvergingBoxes;
pub use hard_boxes::HardBoxes;
pub use hard_motions::{HardFrames, HardMotion};
pub use kind::SceneKind;
pub use stampede::Stampede;
