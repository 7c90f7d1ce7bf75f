//! What the scenes need and Rapier spells differently in three dimensions.

use super::rapier::{na::DMatrix, prelude::*};

/// The volume of the unit ball.
pub(super) const UNIT_BALL: Real = 4.0 / 3.0 * (core::f64::consts::PI as Real);

/// The axes in which a crowd walks: the ground.
pub(super) const PLANE: [usize; 2] = [0, 2];

/// The axis across the way of the movers among sleeping boxes: they run through the gaps.
pub(super) const ACROSS: usize = 2;

/// What keeps a walker upright on its plane.
pub(super) const UPRIGHT: LockedAxes =
    LockedAxes::ROTATION_LOCKED.union(LockedAxes::TRANSLATION_LOCKED_Y);

/// What a joint of a rope holds together.
pub(super) const PIN: JointAxesMask = JointAxesMask::LOCKED_SPHERICAL_AXES;

/// The rotation that lifts the positive side of a horizontal axis by this angle.
pub(super) fn tilt(axis: usize, angle: Real) -> AngVector<Real> {
    match axis {
        0 => Vector::z() * angle,
        _ => Vector::x() * -angle,
    }
}

/// The rotation that lays a capsule along the first axis.
pub(super) fn lying() -> AngVector<Real> {
    Vector::z() * core::f64::consts::FRAC_PI_2 as Real
}

/// An angular velocity of random components.
pub(super) fn turning(mut component: impl FnMut() -> Real) -> AngVector<Real> {
    Vector::from_fn(|_, _| component())
}

/// A height field around the origin, `cells` wide and of this extent, with the height of each corner.
pub(super) fn terrain(
    cells: usize,
    extent: Real,
    mut height: impl FnMut() -> Real,
) -> ColliderBuilder {
    let heights = DMatrix::from_fn(cells + 1, cells + 1, |_, _| height());
    ColliderBuilder::heightfield(heights, vector![extent, 1.0, extent])
}

/// An open surface of triangles: a roof of this half width and height.
pub(super) fn ridge(half: Real, height: Real) -> ColliderBuilder {
    let vertices = vec![
        point![-half, 0.0, -half],
        point![half, 0.0, -half],
        point![half, 0.0, half],
        point![-half, 0.0, half],
        point![0.0, height, 0.0],
    ];
    let triangles = vec![[0, 4, 1], [1, 4, 2], [2, 4, 3], [3, 4, 0]];
    ColliderBuilder::trimesh(vertices, triangles).expect("the roof is a valid mesh")
}
