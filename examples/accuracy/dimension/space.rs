//! Vectors, spelled alike for every flavour of Rapier, and places in `f64`, which errors are measured in.

use super::scenes::rapier::{math::DIM, prelude::*};
use super::version::Vector;

/// The axis along which gravity acts, downward.
pub(super) const UP: usize = 1;

/// What gravity adds to a velocity in a second.
pub(super) const GRAVITY: f64 = 9.81;

/// A place or a difference of two.
pub(super) type Place = [f64; DIM];

/// The place with these coordinates.
pub(super) fn place(coordinate: impl FnMut(usize) -> f64) -> Place {
    std::array::from_fn(coordinate)
}

/// The place at this distance along one axis.
pub(super) fn along(axis: usize, distance: f64) -> Place {
    place(|other| if other == axis { distance } else { 0.0 })
}

/// The place that is shifted by this much.
pub(super) fn plus(from: Place, by: Place) -> Place {
    place(|axis| from[axis] + by[axis])
}

/// How far two places are from each other.
pub(super) fn distance(a: Place, b: Place) -> f64 {
    place(|axis| a[axis] - b[axis])
        .into_iter()
        .map(|x| x * x)
        .sum::<f64>()
        .sqrt()
}

/// Rapier's vector.
pub(super) fn vector(place: Place) -> Vector {
    let mut vector = Vector::default();
    for axis in 0..DIM {
        vector[axis] = place[axis] as Real;
    }
    vector
}

/// Where a body is.
pub(super) fn place_of(body: &RigidBody) -> Place {
    let translation = body.translation();
    place(|axis| f64::from(translation[axis]))
}

/// The axes that gravity does not act along.
pub(super) fn horizontal() -> impl Iterator<Item = usize> {
    (0..DIM).filter(|&axis| axis != UP)
}
