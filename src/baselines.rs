//! The reference algorithms that the paper compares itself with or builds on.
//!
//! They are exact and tested like every kernel, but are here only to be compared with.

mod active_list;
mod axis_sort;
mod coherent_order;
mod coherent_sweep_and_prune;
mod dual_axis_sweep;
mod streamed_segment_tree;
mod sweep_and_prune;

pub use coherent_sweep_and_prune::CoherentSweepAndPrune;
pub use dual_axis_sweep::DualAxisSweep;
pub use streamed_segment_tree::StreamedSegmentTree;
pub use sweep_and_prune::SweepAndPrune;
