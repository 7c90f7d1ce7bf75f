//! The worlds that unisize is tested, measured and shown on.
//!
//! [`dim2`] and [`dim3`] are one source, compiled once against rapier2d and once against rapier3d. A
//! [`dim3::Scene`] is built from a [`SceneKind`], a number of bodies and a seed, and is stepped with any
//! broad phase.

mod kind;

pub mod dim2;
pub mod dim3;

pub use kind::SceneKind;
