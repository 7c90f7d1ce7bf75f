//! The same boxes give the same events in the same order: in another run, on any number of threads, in a clone, on every
//! platform, in whatever way pairs are searched for and colliders listed, and in every version since a golden hash was taken.
//!
//! A changed hash means that the events, or their order, have changed. If that is intended, the test prints the new
//! table.

mod dim2;
mod dim2_f64;
mod dim3;
mod dim3_f64;
mod hash;
