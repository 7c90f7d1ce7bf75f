//! The comparison in rapier3d.

use unisize::rapier3d as ours;
use unisize_scenes::dim3 as scenes;

const DIM: u8 = 3;

#[path = "dimension.rs"]
mod dimension;
pub(super) use dimension::compare;
