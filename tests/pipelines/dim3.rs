//! The suite for rapier3d.

use flavour::{height_field, hinge, mesh_floor, spin};
use rapier3d as rapier;
use unisize::rapier3d::{Settings, UnisizeBroadPhase};
use unisize_scenes::dim3::World;

mod flavour;
mod vehicles;

#[path = "suite/mod.rs"]
mod suite;
