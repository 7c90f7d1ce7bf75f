//! The suite for rapier3d-f64.

use flavour::{height_field, hinge, mesh_floor, spin};
use rapier3d_f64 as rapier;
use unisize::rapier3d_f64::{Settings, UnisizeBroadPhase};
use unisize_scenes::dim3_f64::World;

#[path = "dim3/flavour.rs"]
mod flavour;

#[path = "suite/mod.rs"]
mod suite;

#[path = "dim3/vehicles.rs"]
mod vehicles;
