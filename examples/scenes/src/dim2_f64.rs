//! The scenes for rapier2d-f64.

pub use rapier2d_f64 as rapier;

#[path = "dim2/flavour.rs"]
mod flavour;

#[path = "engine/mod.rs"]
mod engine;
pub use engine::*;
