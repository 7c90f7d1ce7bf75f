//! What the suite needs and is otherwise in space.

#[cfg(test)]
use super::rapier::prelude::SharedShape;
#[cfg(test)]
use super::suite::Solid;
use super::version::{Vector, vector};
use crate::ops::Triple;

/// Solids of revolution, each by its half height, its radius and that of its border.
#[cfg(test)]
pub(super) const SOLIDS: [(&str, Solid); 4] = [
    ("cylinder", |[half, radius, _]| {
        SharedShape::cylinder(half, radius)
    }),
    ("cone", |[half, radius, _]| SharedShape::cone(half, radius)),
    ("round cylinder", |[half, radius, border]| {
        SharedShape::round_cylinder(half, radius, border)
    }),
    ("round cone", |[half, radius, border]| {
        SharedShape::round_cone(half, radius, border)
    }),
];

/// A turn about an axis with these coordinates, by its length.
pub(super) fn turn(angles: Triple) -> Vector {
    vector(angles)
}
