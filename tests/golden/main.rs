//! The same input gives the same events in the same order: again, on any number of threads, in a clone, and on every
//! platform and in every version from which a golden hash was kept.
//!
//! A hash that has changed means that events come in another order, or are others. If that is intended, the table that
//! the test prints is the new one.

mod dim2;
mod dim2_f64;
mod dim3;
mod dim3_f64;
mod hash;
