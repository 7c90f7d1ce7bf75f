//! The overlapping pairs of boxes that lie in a `wgpu` buffer, each once, exactly, by compute shaders.
//!
//! [`GpuSweep`] sorts boxes into the cells of grids, one for each of four size classes, and compares each with those in the cells around
//! it. It needs no optional feature of a device. Which pairs overlap is decided by integers alone.
//!
//! The order of the pairs varies from run to run, because threads race for places; the set does not.

mod buffers;
mod error;
mod gpu;
mod kernels;
mod sweep;

pub use buffers::Capacity;
pub use error::GpuError;
pub use gpu::{Gpu, bind, pipelines, read, upload};
pub use sweep::GpuSweep;
