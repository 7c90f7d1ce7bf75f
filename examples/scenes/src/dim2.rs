//! The scenes for rapier2d.

pub use rapier2d as rapier;

mod flavour;
mod gorge;

#[path = "engine/mod.rs"]
mod engine;
#[path = "show.rs"]
mod show;
pub use engine::*;
pub use gorge::Gorge;
pub use show::{HeldPairs, Show};
