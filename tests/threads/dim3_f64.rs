//! The test for rapier3d-f64.

use rapier3d_f64 as rapier;
use unisize::rapier3d_f64::{Stats, UnisizeBroadPhase};

#[path = "suite.rs"]
mod suite;
