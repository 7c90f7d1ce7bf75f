//! What the scenes need and Rapier spells differently in three dimensions.

use super::engine::space::{Point, Vector, along, vector};
use super::rapier::prelude::*;
use super::version;

/// The volume of the unit ball.
pub(super) const UNIT_BALL: Real = 4.0 / 3.0 * (core::f64::consts::PI as Real);

/// The axes in which a crowd walks: the ground.
pub(super) const PLANE: [usize; 2] = [0, 2];

/// The axis across the way of the movers among sleeping boxes: they run through the gaps.
pub(super) const ACROSS: usize = 2;

/// What keeps a walker upright.
pub(super) const UPRIGHT: LockedAxes = LockedAxes::ROTATION_LOCKED;

/// What a joint of a rope holds together.
pub(super) const PIN: JointAxesMask = JointAxesMask::LOCKED_SPHERICAL_AXES;

/// The rotation that lifts the positive side of a horizontal axis by this angle.
pub(super) fn tilt(axis: usize, angle: Real) -> Vector {
    match axis {
        0 => along(2, 1.0) * angle,
        _ => along(0, 1.0) * -angle,
    }
}

/// The rotation that lays a capsule along the first axis.
pub(super) fn lying() -> Vector {
    along(2, 1.0) * core::f64::consts::FRAC_PI_2 as Real
}

/// An angular velocity of random components.
pub(super) fn turning(mut component: impl FnMut() -> Real) -> Vector {
    vector(|_| component())
}

/// The angular velocity with these components.
pub fn spin(components: [Real; 3]) -> Vector {
    components.into()
}

/// A height field around the origin, `cells` wide and of this extent, with the height of each corner.
pub(super) fn terrain(cells: usize, extent: Real, height: impl FnMut() -> Real) -> ColliderBuilder {
    let heights = version::square(cells + 1, height);
    let scale = vector(|axis| if axis == 1 { 1.0 } else { extent });
    ColliderBuilder::heightfield(heights, scale)
}

/// An open surface of triangles: a roof of this half width and height.
pub(super) fn ridge(half: Real, height: Real) -> ColliderBuilder {
    let corner = |x: Real, z: Real| Point::from(along(0, x * half) + along(2, z * half));
    let vertices = vec![
        corner(-1.0, -1.0),
        corner(1.0, -1.0),
        corner(1.0, 1.0),
        corner(-1.0, 1.0),
        Point::from(along(1, height)),
    ];
    let triangles = vec![[0, 4, 1], [1, 4, 2], [2, 4, 3], [3, 4, 0]];
    ColliderBuilder::trimesh(vertices, triangles).expect("the roof is a valid mesh")
}
