//! Random shapes of every kind.

use oorandom::Rand32;

use super::rapier::prelude::*;
use super::{dim, version};
use crate::ops::Triple;

/// Makes a shape from three lengths.
pub(crate) type Solid = fn([Real; 3]) -> SharedShape;

/// Makes a random shape.
type Maker = fn(&mut Random) -> SharedShape;

/// Lengths that worlds are made of. Parry takes squares of lengths that are below ten rounding errors of 1 for zero, so it cannot
/// tell small shapes apart in `f32`.
const UNITS: [f32; 3] = match Real::MANTISSA_DIGITS {
    24 => [10.0, 100.0, 1000.0],
    _ => [1.0, 0.01, 100.0],
};

/// The shapes that each flavour has.
const SHAPES: [(&str, Maker); 13] = [
    ("ball", |random| SharedShape::ball(random.length())),
    ("capsule", |random| {
        SharedShape::capsule_y(random.length(), random.length())
    }),
    ("capsule off its center", |random| {
        let [a, b] = random.points();
        SharedShape::capsule(a, b, random.length())
    }),
    ("cuboid", |random| SharedShape::new(random.cuboid())),
    ("round cuboid", |random| {
        SharedShape::new(RoundShape {
            inner_shape: random.cuboid(),
            border_radius: random.length(),
        })
    }),
    ("segment", |random| {
        let [a, b] = random.points();
        SharedShape::segment(a, b)
    }),
    ("triangle", |random| {
        let [a, b, c] = random.points();
        SharedShape::triangle(a, b, c)
    }),
    ("convex hull", |random| {
        let points: [_; 8] = random.points();
        SharedShape::convex_hull(&points).unwrap_or(SharedShape::ball(random.length()))
    }),
    ("round convex hull", |random| {
        let (points, border): ([_; 8], _) = (random.points(), random.length());
        SharedShape::round_convex_hull(&points, border).unwrap_or(SharedShape::ball(border))
    }),
    ("compound", |random| {
        let size = random.size();
        let mut part = |shape| (version::translation(random.triple(size)), shape);
        let [half, radius] = [0.5 * Real::from(size), 0.3 * Real::from(size)];
        SharedShape::compound(vec![
            part(SharedShape::ball(radius)),
            part(SharedShape::capsule_x(half, radius)),
        ])
    }),
    ("half-space", |random| {
        version::half_space(random.triple(1.0))
    }),
    ("triangle mesh", |random| {
        let [a, b, c, d] = random.points();
        let mesh = SharedShape::trimesh(vec![a, b, c, d], vec![[0, 1, 2], [1, 2, 3]]);
        mesh.unwrap_or(SharedShape::segment(a, b))
    }),
    ("polyline", |random| {
        let points: [_; 4] = random.points();
        SharedShape::polyline(points.to_vec(), None)
    }),
];

pub(super) const HALF_SPACE: usize = 10;

/// Those that have no volume but their box.
pub(super) const BOXES: std::ops::RangeInclusive<usize> = 11..=12;

pub(super) const KINDS: usize = SHAPES.len() + dim::SOLIDS.len();

/// Random numbers for a world of this length unit.
pub(super) struct Random {
    numbers: Rand32,
    pub(super) unit: f32,
}

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self {
            numbers: Rand32::new(seed),
            unit: UNITS[seed as usize % UNITS.len()],
        }
    }

    pub(super) fn below(&mut self, end: usize) -> usize {
        self.numbers.rand_range(0..end as u32) as usize
    }

    /// Of three orders of magnitude, each as likely as the others.
    fn size(&mut self) -> f32 {
        self.unit * 10.0_f32.powf(3.0 * self.numbers.rand_float() - 2.5)
    }

    pub(super) fn length(&mut self) -> Real {
        self.size().into()
    }

    /// Numbers within this distance of 0.
    pub(super) fn triple(&mut self, distance: f32) -> Triple {
        std::array::from_fn(|_| distance * (2.0 * self.numbers.rand_float() - 1.0))
    }

    /// Within some size of the origin.
    fn points<const N: usize>(&mut self) -> [version::Point; N] {
        let size = self.size();
        std::array::from_fn(|_| version::point(self.triple(size)))
    }

    /// In half of all cases with sides of much the same length.
    fn cuboid(&mut self) -> Cuboid {
        let half = match self.below(2) {
            0 => [self.size(); 3].map(|size| size * (0.5 + 0.5 * self.numbers.rand_float())),
            _ => [(); 3].map(|()| self.size()),
        };
        Cuboid::new(version::vector(half))
    }

    pub(super) fn shape(&mut self) -> (usize, SharedShape) {
        // Few half-spaces: they leave little room.
        let kind = match self.below(KINDS) {
            HALF_SPACE if self.below(4) > 0 => 0,
            kind => kind,
        };
        let shape = match SHAPES.get(kind) {
            Some((_, shape)) => shape(self),
            None => dim::SOLIDS[kind - SHAPES.len()].1([(); 3].map(|()| self.length())),
        };
        (kind, shape)
    }

    pub(super) fn angles(&mut self) -> Triple {
        self.triple(std::f32::consts::PI)
    }
}

pub(super) fn name(kind: usize) -> &'static str {
    let names = SHAPES.iter().map(|shape| shape.0);
    let mut names = names.chain(dim::SOLIDS.iter().map(|solid| solid.0));
    names.nth(kind).expect("there are no other kinds")
}
