//! What a sample says of what it was taken from: middles, bounds of shares, tests of two methods on the same starts, and the correction
//! for many tests.

mod holm;
mod middle;
mod paired;
mod rare;
mod sign;

pub(crate) use holm::holm;
pub(crate) use middle::{geometric_mean, median};
pub(crate) use paired::paired_test;
pub(crate) use rare::rarer_than;
pub(crate) use sign::sign_test;
