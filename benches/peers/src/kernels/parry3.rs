//! Parry's tree in three dimensions.

use parry3d as parry;

#[path = "parry.rs"]
mod parry_kernels;
pub(crate) use parry_kernels::families;
