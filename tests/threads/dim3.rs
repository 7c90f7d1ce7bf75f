//! The test for rapier3d.

use rapier3d as rapier;
use unisize::rapier3d::{Stats, UnisizeBroadPhase};

#[path = "suite.rs"]
mod suite;
