//! The part of the scenes that touches Rapier: one source for both dimensions.

use super::rapier;

mod scene;
mod world;

pub use scene::Scene;
pub use world::World;
