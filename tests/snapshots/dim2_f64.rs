//! The suite for rapier2d-f64.

use rapier2d_f64 as rapier;
use unisize::rapier2d_f64::{Kernel, Settings, Stats, UnisizeBroadPhase};
use unisize_scenes::dim2_f64::Scene;

#[path = "suite/mod.rs"]
mod suite;
