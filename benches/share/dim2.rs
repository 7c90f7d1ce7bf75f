//! The steps of rapier2d.

use unisize::rapier2d as ours;
use unisize_scenes::dim2 as scenes;

#[path = "dimension.rs"]
mod dimension;
pub(crate) use dimension::print;
