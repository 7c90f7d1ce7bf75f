//! The suite for rapier3d 0.36.

use rapier3d_0_36 as rapier;
use unisize::rapier3d_0_36::{Kernel, Settings, UnisizeBroadPhase};

#[path = "suite/mod.rs"]
mod suite;

#[path = "rapier_0_36/mod.rs"]
mod version;

pub(crate) use suite::play;
