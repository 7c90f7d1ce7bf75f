//! The steps of rapier3d.

use unisize::rapier3d as ours;
use unisize_scenes::dim3 as scenes;

#[path = "dimension.rs"]
mod dimension;
pub(crate) use dimension::print;
