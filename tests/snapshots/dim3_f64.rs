//! The suite for rapier3d-f64.

use rapier3d_f64 as rapier;
use unisize::rapier3d_f64::{Kernel, Settings, Stats, UnisizeBroadPhase};
use unisize_scenes::dim3_f64::Scene;

#[path = "suite/mod.rs"]
mod suite;
