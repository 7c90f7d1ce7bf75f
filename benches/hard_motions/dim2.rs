//! The motions in rapier2d.

use rapier2d as rapier;
use unisize::rapier2d as ours;

#[path = "dimension.rs"]
mod dimension;
pub(crate) use dimension::print;
