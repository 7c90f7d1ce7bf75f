//! The suite for rapier2d.

use rapier2d as rapier;
use unisize::rapier2d::{Kernel, Settings, UnisizeBroadPhase};

#[path = "suite/mod.rs"]
mod suite;

pub(crate) use suite::play;
