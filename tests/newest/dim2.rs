//! The suite for rapier2d 0.36.

use rapier2d_0_36 as rapier;
use unisize::rapier2d_0_36::{Settings, UnisizeBroadPhase};

#[path = "suite/mod.rs"]
mod suite;
