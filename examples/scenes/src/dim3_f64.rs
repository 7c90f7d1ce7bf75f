//! The scenes for rapier3d-f64.

pub use rapier3d_f64 as rapier;

#[path = "dim3/flavour.rs"]
mod flavour;

#[path = "engine/mod.rs"]
mod engine;
pub use engine::*;
