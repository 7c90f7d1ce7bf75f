//! The scenes for rapier2d.

pub use rapier2d as rapier;

mod flavour;

#[path = "engine/mod.rs"]
mod engine;
pub use engine::*;
