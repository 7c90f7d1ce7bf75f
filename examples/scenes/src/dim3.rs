//! The scenes for rapier3d.

pub use rapier3d as rapier;

mod flavour;
mod implosion;
mod pour;
mod ropes;
mod solids;

#[path = "engine/mod.rs"]
mod engine;
#[path = "show.rs"]
mod show;
pub use engine::*;
pub use implosion::Implosion;
pub use pour::Pour;
pub use ropes::Ropes;
pub use show::{HeldPairs, Show};
