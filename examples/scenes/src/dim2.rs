//! The scenes for rapier2d.

pub use rapier2d as rapier;

#[path = "engine/mod.rs"]
mod engine;
pub use engine::*;
