//! The scenes for rapier3d.

pub use rapier3d as rapier;

mod flavour;

#[path = "engine/mod.rs"]
mod engine;
pub use engine::*;
