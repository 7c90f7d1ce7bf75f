//! Solids of revolution, each by its half height, its radius and that of its border.

use super::rapier::prelude::SharedShape;
use super::suite::Solid;

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
