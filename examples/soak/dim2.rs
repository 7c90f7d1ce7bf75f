//! The soak in rapier2d.

use rapier2d as rapier;
use unisize::rapier2d::UnisizeBroadPhase;

#[path = "soak.rs"]
mod soak;
pub(crate) use soak::Soak;
