//! The measurements in rapier3d.

use unisize::rapier3d as ours;
use unisize_scenes::dim3 as scenes;

const DIM: u8 = 3;

#[path = "dimension/mod.rs"]
mod dimension;
pub(super) use dimension::study;
