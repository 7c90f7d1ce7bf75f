//! rapier2d 0.36.

use rapier2d_036 as rapier;

#[path = "../engine/v036.rs"]
mod engine;
#[path = "../engine/world.rs"]
mod world;
pub(super) use engine::BVH;
