//! The suite for rapier3d 0.36.

use rapier3d_0_36 as rapier;
use unisize::rapier3d_0_36::{Settings, UnisizeBroadPhase};

#[path = "suite/mod.rs"]
mod suite;
