//! The suite for rapier3d.

use rapier3d as rapier;
use unisize::rapier3d::{Kernel, Settings, UnisizeBroadPhase};

#[path = "suite/mod.rs"]
mod suite;

#[path = "rapier_0_27/mod.rs"]
mod version;

pub(crate) use suite::play;
