//! The measurements in rapier2d.

use unisize::rapier2d as ours;
use unisize_scenes::dim2 as scenes;

const DIM: u8 = 2;

#[path = "dimension/mod.rs"]
mod dimension;
pub(super) use dimension::study;
