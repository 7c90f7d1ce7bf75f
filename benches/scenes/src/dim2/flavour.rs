//! What the scenes need and Rapier spells differently in two dimensions.

use super::engine::space::{Point, along, vector};
use super::rapier::prelude::*;

/// The area of the unit ball.
pub(super) const UNIT_BALL: Real = core::f64::consts::PI as Real;

/// The axes in which a crowd walks: it is seen from above.
pub(super) const PLANE: [usize; 2] = [0, 1];

/// The axis across the way of the movers among sleeping boxes: they pass over them.
pub(super) const ACROSS: usize = 1;

/// What keeps a walker upright.
pub(super) const UPRIGHT: LockedAxes = LockedAxes::ROTATION_LOCKED_Z;

/// What a joint of a rope holds together.
pub(super) const PIN: JointAxesMask = JointAxesMask::LOCKED_REVOLUTE_AXES;

/// The rotation that lifts the positive side of a horizontal axis by this angle.
pub(super) fn tilt(_axis: usize, angle: Real) -> Real {
    angle
}

/// The rotation that lays a capsule along the first axis.
pub(super) fn lying() -> Real {
    core::f64::consts::FRAC_PI_2 as Real
}

/// An angular velocity of random components.
pub(super) fn turning(mut component: impl FnMut() -> Real) -> Real {
    component()
}

/// The angular velocity with this component about the third axis. A world of two dimensions has no others.
pub fn spin([_, _, z]: [Real; 3]) -> Real {
    z
}

/// A height field around the origin, `cells` wide and of this extent, with the height of each column.
pub(super) fn terrain(
    cells: usize,
    extent: Real,
    mut height: impl FnMut() -> Real,
) -> ColliderBuilder {
    let heights: Vec<_> = (0..=cells).map(|_| height()).collect();
    let scale = vector(|axis| if axis == 0 { extent } else { 1.0 });
    ColliderBuilder::heightfield(heights.into(), scale)
}

/// An open surface of segments: a ridge of this half width and height.
pub(super) fn ridge(half: Real, height: Real) -> ColliderBuilder {
    let vertices = [along(0, -half), along(1, height), along(0, half)];
    let vertices = vertices.into_iter().map(Point::from).collect();
    ColliderBuilder::polyline(vertices, None)
}
