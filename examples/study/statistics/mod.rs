//! What a sample says of what it was taken from: intervals of medians, bounds of shares, a test of two methods on the same starts, and the
//! correction for many tests.

mod holm;
mod median;
mod paired;
mod rare;

pub(crate) use holm::holm;
pub(crate) use median::Median;
pub(crate) use paired::paired_test;
pub(crate) use rare::rarer_than;
