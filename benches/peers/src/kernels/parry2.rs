//! Parry's tree in two dimensions.

use parry2d as parry;

#[path = "parry.rs"]
mod parry_kernels;
pub(crate) use parry_kernels::families;
