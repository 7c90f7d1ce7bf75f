//! What a sample says of what it was taken from: intervals of shares and medians, a test of two methods on the same starts, and the
//! correction for many tests.

mod holm;
mod median;
mod paired;
mod share;

pub(crate) use holm::holm;
pub(crate) use median::Median;
pub(crate) use paired::paired_test;
pub(crate) use share::Share;
