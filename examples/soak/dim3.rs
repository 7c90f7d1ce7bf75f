//! The soak in rapier3d.

use rapier3d as rapier;
use unisize::rapier3d::UnisizeBroadPhase;

#[path = "soak.rs"]
mod soak;
pub(crate) use soak::Soak;
