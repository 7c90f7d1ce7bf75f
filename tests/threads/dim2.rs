//! The test for rapier2d.

use rapier2d as rapier;
use unisize::rapier2d::{Stats, UnisizeBroadPhase};

#[path = "suite.rs"]
mod suite;
