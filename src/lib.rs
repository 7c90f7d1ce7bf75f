//! placeholder

mod aabb;
mod brute_force;
mod invalid_box;
mod pair_finder;
mod real;

pub use aabb::Aabb;
pub use brute_force::BruteForce;
pub use invalid_box::{InvalidBox, InvalidBoxReason};
pub use pair_finder::PairFinder;
pub use real::Real;
