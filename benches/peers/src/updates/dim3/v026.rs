//! rapier3d 0.26.

use rapier3d_026 as rapier;

#[path = "../engine/v026.rs"]
mod engine;
#[path = "../engine/world.rs"]
mod world;
pub(super) use engine::MULTI_SAP;
