//! Vectors and shapes, with the same names in both dimensions.

use super::rapier::{math::DIM, na::ComplexField, parry::shape::Cuboid, prelude::*};
use crate::random::Random;
use std::borrow::Borrow;

pub(in super::super) use super::version::{Point, Vector};

/// The axis along which gravity acts, downward.
pub(super) const UP: usize = 1;

/// The acceleration of gravity.
pub(super) const GRAVITY: Real = 9.81;

/// The vector with these components.
pub fn vector(mut component: impl FnMut(usize) -> Real) -> Vector {
    let mut vector = Vector::default();
    for axis in 0..DIM {
        vector[axis] = component(axis);
    }
    vector
}

/// The vector of this length along one axis.
pub fn along(axis: usize, length: Real) -> Vector {
    vector(|other| if other == axis { length } else { 0.0 })
}

/// The vector with one component for the horizontal axes and one for the vertical axis.
pub(super) fn wide_high(wide: Real, high: Real) -> Vector {
    vector(|axis| if axis == UP { high } else { wide })
}

/// The horizontal axes.
pub(super) fn horizontal() -> impl Iterator<Item = usize> {
    (0..DIM).filter(|&axis| axis != UP)
}

/// A vector that one version of the engine returns by reference, and another by value.
pub fn own(vector: impl Borrow<Vector>) -> Vector {
    *vector.borrow()
}

/// The components of a vector.
pub(super) fn components(vector: Vector) -> [Real; DIM] {
    std::array::from_fn(|axis| vector[axis])
}

/// The scalar product.
pub(super) fn dot(a: Vector, b: Vector) -> Real {
    (0..DIM).map(|axis| a[axis] * b[axis]).sum()
}

/// The length of a vector, squared.
pub(super) fn length_squared(vector: Vector) -> Real {
    dot(vector, vector)
}

/// The length of a vector.
pub fn length(vector: Vector) -> Real {
    length_squared(vector).sqrt()
}

/// The largest component of a vector.
pub(super) fn largest(vector: Vector) -> Real {
    components(vector)
        .into_iter()
        .fold(Real::NEG_INFINITY, Real::max)
}

/// The vector of length 1 in this direction; along the first axis where there is none.
pub(super) fn direction(vector: Vector) -> Vector {
    let length = length(vector);
    if length > 0.0 {
        vector / length
    } else {
        along(0, 1.0)
    }
}

/// A vector with each component in `-amount..amount`.
pub(super) fn jitter(random: &mut Random, amount: Real) -> Vector {
    vector(|_| random.range(-amount, amount))
}

/// A number in `lo..hi` whose logarithm is uniform.
pub(super) fn log_range(random: &mut Random, lo: Real, hi: Real) -> Real {
    let share: Real = random.range(0.0, 1.0);
    lo * power(hi / lo, share)
}

/// A cuboid, from its half extents.
pub(super) fn cuboid(half: Vector) -> ColliderBuilder {
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
