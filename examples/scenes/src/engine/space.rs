//! Vectors and shapes, spelled alike in both dimensions.

use super::rapier::{math::DIM, na::ComplexField, parry::shape::Cuboid, prelude::*};
use crate::random::Random;

/// The axis along which gravity acts, downward.
pub(super) const UP: usize = 1;

/// What gravity adds to a velocity in a second.
pub(super) const GRAVITY: Real = 9.81;

/// The vector with these components.
pub(super) fn vector(mut component: impl FnMut(usize) -> Real) -> Vector<Real> {
    Vector::from_fn(|axis, _| component(axis))
}

/// The vector of this length along one axis.
pub(super) fn along(axis: usize, length: Real) -> Vector<Real> {
    vector(|other| if other == axis { length } else { 0.0 })
}

/// The vector with one component for the horizontal axes and one for the vertical axis.
pub(super) fn wide_high(wide: Real, high: Real) -> Vector<Real> {
    vector(|axis| if axis == UP { high } else { wide })
}

/// The horizontal axes.
pub(super) fn horizontal() -> impl Iterator<Item = usize> {
    (0..DIM).filter(|&axis| axis != UP)
}

/// A vector with each component in `-amount..amount`.
pub(super) fn jitter(random: &mut Random, amount: Real) -> Vector<Real> {
    vector(|_| random.range(-amount, amount))
}

/// A number in `lo..hi` whose logarithm is uniform.
pub(super) fn log_range(random: &mut Random, lo: Real, hi: Real) -> Real {
    let share: Real = random.range(0.0, 1.0);
    lo * power(hi / lo, share)
}

/// A cuboid, from its half extents.
pub(super) fn cuboid(half: Vector<Real>) -> ColliderBuilder {
    ColliderBuilder::new(SharedShape::new(Cuboid::new(half)))
}

/// A cuboid with equal half extents.
pub(super) fn cube(half: Real) -> ColliderBuilder {
    cuboid(vector(|_| half))
}

/// A power, as the engine computes it: the same on every platform with its feature `enhanced-determinism`.
pub(super) fn power(base: Real, exponent: Real) -> Real {
    ComplexField::powf(base, exponent)
}

/// A sine, as the engine computes it.
pub(super) fn sine(angle: Real) -> Real {
    ComplexField::sin(angle)
}

/// A cosine, as the engine computes it.
pub(super) fn cosine(angle: Real) -> Real {
    ComplexField::cos(angle)
}
