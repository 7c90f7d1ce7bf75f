//! The axes that may separate two volumes.

use super::{VolumeKind, VolumeRef, at_least_exact, dot, sub};
use crate::real::Real;

/// Two volumes, and the numbers that the tests of all axes share.
pub(super) struct Pair<'a, R, const D: usize> {
    pub(super) volumes: [VolumeRef<'a, R, D>; 2],
    /// The vector from the first center to the second one.
    pub(super) between: [R; D],
    /// The sum of both radii and the slack.
    pub(super) reach: R,
}

impl<'a, R: Real, const D: usize> Pair<'a, R, D> {
    /// Two volumes, each loosened by half of `slack`.
    #[inline(always)]
    pub(super) fn of(a: VolumeRef<'a, R, D>, b: VolumeRef<'a, R, D>, slack: R) -> Self {
        Self {
            between: sub(b.ball.center, a.ball.center),
            reach: a.radius() + b.radius() + slack,
            volumes: [a, b],
        }
    }

    /// Whether the intervals along an axis do not meet. `segments` is the reach of both volumes' segments along the axis, times the length of
    /// the axis, which is arbitrary. False for NaN.
    #[inline(always)]
    fn is_apart(&self, axis: [R; D], segments: R) -> bool {
        self.are_beyond_reach(dot(self.between, axis).abs(), axis, segments)
    }

    /// Whether a distance along an axis exceeds the reach of both volumes. `distance` and `segments` are multiplied by the length of the axis.
    /// False for NaN.
    #[inline(always)]
    fn are_beyond_reach(&self, distance: R, axis: [R; D], segments: R) -> bool {
        let squared = dot(axis, axis);
        // An axis is at most as long as the sum of all numbers of both volumes. So if its square has not lost digits to underflow, the
        // bound on rounding errors exceeds the underflow in every product.
        (squared >= R::LEAST_EXACT) & is_beyond(distance, self.reach * squared.sqrt() + segments)
    }

    /// Whether an axis of the world separates them.
    #[inline(always)]
    pub(super) fn is_apart_in_world(&self) -> bool {
        let [a, b] = self.volumes;
        let mut reach = [self.reach; D];
        for half in a.half_axes.iter().chain(b.half_axes) {
            for k in 0..D {
                reach[k] = reach[k] + half[k].abs();
            }
        }
        (0..D).any(|k| is_beyond(self.between[k].abs(), reach[k]))
    }

    /// Whether an axis of the first volume separates them, if it is a cuboid.
    #[inline(always)]
    pub(super) fn is_apart_by_sides(&self, [cuboid, other]: [VolumeRef<'a, R, D>; 2]) -> bool {
        cuboid.kind == VolumeKind::Cuboid
            && cuboid.half_axes.iter().any(|&axis| {
                // The other axes of the cuboid are orthogonal except for rounding errors, which the radius includes.
                self.is_apart(axis, dot(axis, axis) + other.reach_of_segments(axis))
            })
    }

    /// Whether the other volume is in front of a half-space.
    pub(super) fn is_in_front(&self, [half_space, other]: [VolumeRef<'a, R, D>; 2]) -> bool {
        let normal = half_space.half_axes[0];
        let height = dot(sub(other.ball.center, half_space.ball.center), normal);
        self.are_beyond_reach(height, normal, other.reach_of_segments(normal))
    }

    /// Whether the line from the closest point of this volume's segments to the center of the other volume separates them. The point is
    /// approximate.
    #[inline(always)]
    pub(super) fn is_apart_by_shortest(&self, volume: VolumeRef<'a, R, D>) -> bool {
        // The direction of the line does not matter.
        let axis = volume.half_axes.iter().fold(self.between, |axis, &half| {
            let t = clamped(dot(self.between, half), dot(half, half));
            core::array::from_fn(|k| axis[k] - t * half[k])
        });
        let [a, b] = self.volumes;
        self.is_apart(axis, a.reach_of_segments(axis) + b.reach_of_segments(axis))
    }

    /// Whether the line of centers separates two capsules, or the line between the closest points of their segments. The points are approximate,
    /// and the segment of a ball is its center. Both tests share their products.
    #[inline(always)]
    pub(super) fn cores_are_apart(&self) -> bool {
        let first = |volume: VolumeRef<'_, R, D>| volume.half_axes.first().copied();
        let [u, v] = self
            .volumes
            .map(|volume| first(volume).unwrap_or([R::ZERO; D]));
        let between = self.between;
        let (dd, [ud, vd]) = (dot(between, between), [u, v].map(|half| dot(half, between)));
        if self.are_beyond_reach(dd, between, ud.abs() + vd.abs()) {
            return true;
        }
        let axis = nearest_points(between, [u, v], [ud, vd]);
        self.is_apart(axis, dot(u, axis).abs() + dot(v, axis).abs())
    }
}

/// Whether a sum of products exceeds another one, whatever underflow has done to both. False for NaN, and if overflow has made the first sum
/// infinite.
#[inline(always)]
fn is_beyond<R: Real>(distance: R, reach: R) -> bool {
    (distance > at_least_exact(reach)) & distance.is_finite()
}

/// The vector between the approximate closest points of two segments with the half axes `u` and `v`. `between` is the vector between their
/// centers, and `ud` and `vd` are its products with the half axes.
///
/// See Ericson, Real-Time Collision Detection, 5.1.9.
#[inline(always)]
pub(super) fn nearest_points<R: Real, const D: usize>(
    between: [R; D],
    [u, v]: [[R; D]; 2],
    [ud, vd]: [R; 2],
) -> [R; D] {
    let [uu, uv, vv] = [dot(u, u), dot(u, v), dot(v, v)];
    let s = clamped(ud * vv - vd * uv, uu * vv - uv * uv);
    let t = clamped(s * uv - vd, vv);
    let s = clamped(t * uv + ud, uu);
    core::array::from_fn(|k| between[k] + t * v[k] - s * u[k])
}

/// A quotient, clamped to -1 to 1; 0 if the denominator is not positive.
#[inline(always)]
fn clamped<R: Real>(numerator: R, denominator: R) -> R {
    let one = R::from_f64(1.0);
    let quotient = numerator / denominator;
    match denominator > R::ZERO {
        false => R::ZERO,
        true if quotient > one => one,
        true if quotient < R::ZERO - one => R::ZERO - one,
        true => quotient,
    }
}
