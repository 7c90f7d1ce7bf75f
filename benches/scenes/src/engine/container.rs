//! Where the bodies of a scene are meant to stay, and the colliders that keep them there.

use super::rapier::{math::DIM, na::Unit, prelude::*};
use super::space::{UP, Vector, along, cuboid, horizontal, vector};
use super::world::World;

/// The thickness of floors and walls. What falls for ten seconds moves by less than this in a step.
const THICKNESS: Real = 4.0;

/// A box in which bodies are meant to stay; infinite where they are free to leave.
#[derive(Clone, Copy)]
pub(super) struct Container {
    /// The lower corner.
    pub(super) lo: Vector,
    /// The upper corner.
    pub(super) hi: Vector,
}

impl Container {
    /// A box around the vertical axis that stands on height zero.
    pub(super) fn standing(half_width: Real, height: Real) -> Self {
        Self {
            lo: vector(|axis| if axis == UP { 0.0 } else { -half_width }),
            hi: vector(|axis| if axis == UP { height } else { half_width }),
        }
    }

    /// The half-space above height zero.
    pub(super) fn above_ground() -> Self {
        Self::standing(Real::INFINITY, Real::INFINITY)
    }

    /// The same box, which bodies may leave through its top.
    pub(super) fn open(mut self) -> Self {
        self.hi[UP] = Real::INFINITY;
        self
    }

    /// Whether a body of this size is outside by more than its size.
    pub(super) fn is_left_by(&self, center: Vector, size: Real) -> bool {
        (0..DIM)
            .any(|axis| center[axis] < self.lo[axis] - size || center[axis] > self.hi[axis] + size)
    }

    /// Inserts a floor, walls and perhaps a lid of cuboids, which have no bodies. All extents must be finite.
    pub(super) fn wall_in(
        &self,
        world: &mut World,
        has_lid: bool,
        cover: impl Fn(ColliderBuilder) -> Collider,
    ) {
        let walls = horizontal().flat_map(|axis| [(axis, false), (axis, true)]);
        let lid = has_lid.then_some((UP, true));
        for (axis, is_upper) in std::iter::once((UP, false)).chain(walls).chain(lid) {
            let mut center = (self.lo + self.hi) / 2.0;
            // The sides overlap at the edges, so that nothing slips out between them.
            let mut half = (self.hi - self.lo) / 2.0 + vector(|_| THICKNESS);
            center[axis] = match is_upper {
                true => self.hi[axis] + THICKNESS / 2.0,
                false => self.lo[axis] - THICKNESS / 2.0,
            };
            half[axis] = THICKNESS / 2.0;
            let side = cuboid(half).translation(center);
            world.colliders.insert(cover(side));
        }
    }

    /// Inserts a floor and walls of half-spaces, which have no bodies.
    pub(super) fn dig(&self, world: &mut World) {
        let mut insert = |outward: Vector, at: Vector| {
            let normal = Unit::new_unchecked(outward);
            world
                .colliders
                .insert(ColliderBuilder::halfspace(normal).translation(at));
        };
        insert(along(UP, 1.0), along(UP, self.lo[UP]));
        for axis in horizontal().filter(|&axis| self.hi[axis].is_finite()) {
            insert(along(axis, 1.0), along(axis, self.lo[axis]));
            insert(along(axis, -1.0), along(axis, self.hi[axis]));
        }
    }
}
