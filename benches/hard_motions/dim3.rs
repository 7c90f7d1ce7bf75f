//! The motions in rapier3d.

use rapier3d as rapier;
use unisize::rapier3d as ours;

#[path = "dimension.rs"]
mod dimension;
pub(crate) use dimension::print;
