//! The suite for rapier2d 0.36.

use rapier2d_0_36 as rapier;
use unisize::rapier2d_0_36::{Kernel, Settings, UnisizeBroadPhase};

#[path = "suite/mod.rs"]
mod suite;

#[path = "rapier_0_36/mod.rs"]
mod version;

pub(crate) use suite::play;
