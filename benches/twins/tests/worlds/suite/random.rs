//! Random places, poses and shapes: many from short tables, so that several are often exactly as near as each other.

use oorandom::Rand32;

use super::mesh_floor;
use super::rapier::prelude::*;
use super::scenes::{Pose, Vector, pose};
use super::twins::{spin, triple};

/// Radii and half extents, tiny and huge ones among them.
const LENGTHS: [Real; 8] = [0.5, 0.25, 1.0, 0.5, 3.0, 0.01, 0.001, 200.0];

/// Coordinates of places and velocities.
const NUMBERS: [Real; 9] = [0.0, 0.5, -0.5, 1.0, -1.0, 2.5, -2.5, 4.0, -4.0];

pub(crate) struct Random(Rand32);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(Rand32::new(seed))
    }

    pub(crate) fn below(&mut self, end: usize) -> usize {
        self.0.rand_range(0..end as u32) as usize
    }

    pub(crate) fn pick<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[self.below(choices.len())]
    }

    pub(crate) fn within(&mut self, distance: Real) -> Vector {
        triple([(); 3].map(|()| distance * (2.0 * self.0.rand_float() - 1.0) as Real))
    }

    pub(crate) fn length(&mut self) -> Real {
        match self.below(2) {
            0 => self.pick(&LENGTHS),
            _ => 0.05 + 1.95 * self.0.rand_float() as Real,
        }
    }

    pub(crate) fn place(&mut self) -> Vector {
        match self.below(13) {
            0..6 => triple([(); 3].map(|()| self.pick(&NUMBERS))),
            6..12 => self.within(12.0),
            _ => self.within(300.0),
        }
    }

    /// A velocity, or a direction that leads somewhere in two dimensions as well.
    pub(crate) fn direction(&mut self) -> Vector {
        let [x, y, z] = match self.below(2) {
            0 => [(); 3].map(|()| self.pick(&NUMBERS)),
            _ => [(); 3].map(|()| 10.0 * self.0.rand_float() as Real - 5.0),
        };
        triple([if x == 0.0 && y == 0.0 { 1.0 } else { x }, y, z])
    }

    pub(crate) fn pose(&mut self) -> Pose {
        let turn = [0.0, 6.0 * self.0.rand_float() as Real - 3.0][self.below(2)];
        let placed = ColliderBuilder::ball(1.0).translation(self.place());
        *placed.rotation(spin(turn)).build().position()
    }

    /// A shape that can be cast.
    pub(crate) fn probe(&mut self) -> SharedShape {
        let [a, b, c] = [(); 3].map(|()| self.length());
        match self.below(11) {
            0..4 => SharedShape::ball(a),
            4..8 => SharedShape::new(Cuboid::new(triple([a, b, c]))),
            8..10 => SharedShape::capsule_y(a, b),
            _ => {
                let ball = |gap| (pose(triple([gap; 3])), SharedShape::ball(a));
                SharedShape::compound(vec![ball(0.0), ball(b)])
            }
        }
    }

    pub(crate) fn shape(&mut self) -> SharedShape {
        match self.below(10) {
            0 => mesh_floor(self.length()).shape,
            _ => self.probe(),
        }
    }
}
