//! The suite for rapier3d.

use rapier3d as rapier;
use unisize::rapier3d::{Kernel, Settings, Stats, UnisizeBroadPhase};
use unisize_scenes::dim3::Scene;

#[path = "suite/mod.rs"]
mod suite;
