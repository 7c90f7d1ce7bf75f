//! The suite for rapier2d.

use flavour::{height_field, hinge, mesh_floor, spin};
use rapier2d as rapier;
use unisize::rapier2d::{Settings, UnisizeBroadPhase};
use unisize_scenes::dim2::World;

mod flavour;

#[path = "suite/mod.rs"]
mod suite;
