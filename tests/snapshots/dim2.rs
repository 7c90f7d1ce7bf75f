//! The suite for rapier2d.

use rapier2d as rapier;
use unisize::rapier2d::{Kernel, Settings, Stats, UnisizeBroadPhase};
use unisize_scenes::dim2::Scene;

#[path = "suite/mod.rs"]
mod suite;
