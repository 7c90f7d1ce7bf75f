//! The test for rapier2d-f64.

use rapier2d_f64 as rapier;
use unisize::rapier2d_f64::{Stats, UnisizeBroadPhase};

#[path = "suite.rs"]
mod suite;
