//! rapier3d 0.36.

use rapier3d_036 as rapier;

#[path = "../engine/v036.rs"]
mod engine;
#[path = "../engine/world.rs"]
mod world;
pub(super) use engine::BVH;
