//! rapier2d 0.27.

use rapier2d as rapier;
use unisize::rapier2d as ours;

#[path = "../engine/v027.rs"]
mod engine;
#[path = "../engine/world.rs"]
mod world;
pub(super) use engine::{DEFAULT, OURS};
