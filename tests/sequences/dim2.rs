//! The suite for rapier2d.

use rapier2d as rapier;
use unisize::rapier2d::{Kernel, Settings, UnisizeBroadPhase};

#[path = "suite/mod.rs"]
mod suite;

#[path = "rapier_0_27/mod.rs"]
mod version;

pub(crate) use suite::play;
