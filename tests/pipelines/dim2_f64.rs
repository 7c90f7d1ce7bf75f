//! The suite for rapier2d-f64.

use flavour::{height_field, hinge, mesh_floor, spin};
use rapier2d_f64 as rapier;
use unisize::rapier2d_f64::{Settings, UnisizeBroadPhase};
use unisize_scenes::dim2_f64::World;

#[path = "dim2/flavour.rs"]
mod flavour;

#[path = "suite/mod.rs"]
mod suite;
