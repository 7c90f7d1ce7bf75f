//! The statistics of an ensemble: the median with its band, a test of two methods on the same starts, and the correction for
//! many tests.

mod holm;
mod median;
mod paired;

pub(crate) use holm::holm;
pub(crate) use median::Median;
pub(crate) use paired::paired_test;
