//! The bounding volume of a collider's shape: what tells pairs apart whose boxes overlap and whose shapes cannot meet.
//!
//! A box is empty in its corners: around a ball by 21 % in the plane and 48 % in space, around a tilted capsule by more. The
//! paper goes from two dimensions to three by one more interval test; this is that step taken further, to as many axes as a
//! pair needs. A volume is a sum of a point, a ball and up to `D` segments, so its interval along *any* axis `n` is
//! `c · n ± (r |n| + Σ |h · n|)`. Two volumes are apart if their intervals along one of these axes do not meet:
//!
//! | pair | axes |
//! |---|---|
//! | balls | the line of centres |
//! | balls and capsules | the line of centres, and that of the points of their core segments that are nearest to each other |
//! | with a cuboid | the line of centres, the axes of the world, the axes of the cuboids |
//! | with a half-space | its normal |
//!
//! Volumes that are apart have an axis that proves it, whichever it is and however inexactly it was found. So an axis that
//! was badly chosen costs a pair that need not be, and never one that must be.
//!
//! The idea of intervals along more axes than those of the world is that of k-DOPs (Klosowski and others 1998); axes that
//! are chosen for each pair are those of the separating-axis test (Gottschalk and others 1996). Both need a fraction of the
//! memory of a k-DOP, and tell more pairs apart.

use crate::{Aabb, Real};

#[cfg(test)]
mod tests;

/// The bounding volume of a shape in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Volume<R, const D: usize> {
    pub(crate) kind: VolumeKind,
    /// The centre; of a half-space, a point on its plane. If it has a NaN, the volume meets all.
    pub(crate) center: [R; D],
    /// The radius of the ball, at least 0.
    pub(crate) radius: R,
    /// The halves of the segments, as many as its kind has; zeros behind them.
    pub(crate) half_axes: [[R; D]; D],
}

/// What a volume is the volume of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) enum VolumeKind {
    /// All that is known is the box: it meets all whose boxes it overlaps.
    #[default]
    Box,
    Ball,
    /// One segment.
    Capsule,
    /// `D` segments, at right angles.
    Cuboid,
    /// Everything behind a plane, whose unit normal is the first half axis.
    HalfSpace,
}

impl VolumeKind {
    /// How many half axes it has.
    pub(crate) fn axes<const D: usize>(self) -> usize {
        match self {
            Self::Box | Self::Ball => 0,
            Self::Capsule | Self::HalfSpace => 1,
            Self::Cuboid => D,
        }
    }
}

/// In rounding errors of the numbers that make two volumes: what their distance may be wrong by. The engine computes boxes and
/// contacts of its own, with other roundings, and must not find one between volumes that are apart.
const ROUNDINGS: f64 = 8.0;

impl<R: Real, const D: usize> Volume<R, D> {
    /// A volume that meets all.
    pub(crate) const BOX: Self = Self {
        kind: VolumeKind::Box,
        center: [R::NAN; D],
        radius: R::ZERO,
        half_axes: [[R::ZERO; D]; D],
    };

    pub(crate) fn new(kind: VolumeKind, center: [R; D], radius: R, half_axes: &[[R; D]]) -> Self {
        let mut volume = Self {
            kind,
            center,
            radius,
            ..Self::BOX
        };
        let count = kind.axes::<D>();
        volume.half_axes[..count].copy_from_slice(&half_axes[..count]);
        volume
    }

    /// The ball of this radius in the middle of a box.
    #[inline(always)]
    fn ball_in(aabb: &Aabb<R, D>, radius: R) -> Self {
        let half = R::from_f64(0.5);
        let center = core::array::from_fn(|k| (aabb.mins[k] + aabb.maxs[k]) * half);
        Self::new(VolumeKind::Ball, center, radius, &[])
    }

    /// The volume of a collider that has this box: a ball is in the middle of it, and other volumes stay where they are, but
    /// any must [fill](Self::filling) it.
    #[inline(always)]
    pub(crate) fn in_box(self, aabb: &Aabb<R, D>) -> Self {
        match self.kind {
            VolumeKind::Ball => Self::ball_in(aabb, self.radius).filling(aabb),
            _ => self.filling(aabb),
        }
    }

    /// The same volume if it fills a box, on each axis of the world; otherwise one that meets all. A box that the volume does
    /// not fill is of more than the shape as it stands, say of its way to where it will be.
    #[inline(always)]
    fn filling(self, aabb: &Aabb<R, D>) -> Self {
        if self.kind == VolumeKind::Box || self.kind == VolumeKind::HalfSpace {
            return self;
        }
        let tolerance = self.rounding();
        let mut fills = true;
        for k in 0..D {
            let reach = self.half_axes[..self.kind.axes::<D>()]
                .iter()
                .fold(self.radius + tolerance, |sum, half| sum + half[k].abs());
            fills &=
                (self.center[k] - reach <= aabb.mins[k]) & (aabb.maxs[k] <= self.center[k] + reach);
        }
        Self {
            center: if fills { self.center } else { [R::NAN; D] },
            ..self
        }
    }

    /// Whether two volumes may meet, both loosened by half of `slack`: whether none of their axes tells them apart.
    #[inline(always)]
    pub(crate) fn meets(&self, other: &Self, slack: R) -> bool {
        use VolumeKind::{Ball, Box, Capsule, HalfSpace};
        let pair = Pair {
            between: sub(other.center, self.center),
            reach: self.radius + other.radius + slack + (self.rounding() + other.rounding()),
            volumes: [self, other],
        };
        match (self.kind, other.kind) {
            (Box, _) | (_, Box) | (HalfSpace, HalfSpace) => true,
            (Ball, Ball) => !(dot(pair.between, pair.between) > pair.reach * pair.reach),
            (HalfSpace, _) => !pair.is_in_front(self.half_axes[0], pair.between, other),
            (_, HalfSpace) => {
                !pair.is_in_front(other.half_axes[0], sub(self.center, other.center), self)
            }
            (Ball | Capsule, Ball | Capsule) => {
                !(pair.is_apart(pair.between) || pair.is_apart(pair.shortest_between_cores()))
            }
            _ => !pair.is_apart(pair.between) && !pair.is_apart_by_sides(),
        }
    }

    /// What rounding may do to it.
    #[inline(always)]
    fn rounding(&self) -> R {
        let mut size = self.radius;
        for x in self.center {
            size = size + x.abs();
        }
        for half in &self.half_axes[..self.kind.axes::<D>()] {
            for x in half {
                size = size + x.abs();
            }
        }
        size * R::from_f64(ROUNDINGS) * R::EPSILON
    }

    /// How far its segments reach from its centre along an axis, times the length of the axis.
    #[inline(always)]
    fn reach_of_segments(&self, axis: [R; D]) -> R {
        let halves = &self.half_axes[..self.kind.axes::<D>()];
        halves
            .iter()
            .fold(R::ZERO, |sum, &half| sum + dot(half, axis).abs())
    }
}

/// Two volumes that may be apart.
struct Pair<'a, R, const D: usize> {
    volumes: [&'a Volume<R, D>; 2],
    /// From the first centre to the second one.
    between: [R; D],
    /// The sum of what loosens them: radii, slack and rounding.
    reach: R,
}

impl<R: Real, const D: usize> Pair<'_, R, D> {
    /// Whether their intervals along an axis of any length do not meet. False if that cannot be told.
    #[inline(always)]
    fn is_apart(&self, axis: [R; D]) -> bool {
        let [a, b] = self.volumes;
        let reach = self.reach * dot(axis, axis).sqrt()
            + (a.reach_of_segments(axis) + b.reach_of_segments(axis));
        dot(self.between, axis).abs() > reach
    }

    /// Whether they are apart along an axis of the world or of a cuboid.
    fn is_apart_by_sides(&self) -> bool {
        let mut unit = [R::ZERO; D];
        for k in 0..D {
            unit[k] = R::from_f64(1.0);
            if self.is_apart(unit) {
                return true;
            }
            unit[k] = R::ZERO;
        }
        let cuboids = self.volumes.iter();
        let cuboids = cuboids.filter(|volume| volume.kind == VolumeKind::Cuboid);
        cuboids
            .flat_map(|cuboid| cuboid.half_axes)
            .any(|axis| self.is_apart(axis))
    }

    /// Whether a volume, with its centre at `center` from a point on a plane, is in front of the plane.
    fn is_in_front(&self, normal: [R; D], center: [R; D], volume: &Volume<R, D>) -> bool {
        let reach = self.reach * dot(normal, normal).sqrt() + volume.reach_of_segments(normal);
        dot(center, normal) > reach
    }

    /// From the first one's segment to the second one's, where they are nearest, or nearly so. A ball's segment is a point.
    ///
    /// See Ericson, Real-Time Collision Detection, 5.1.9.
    fn shortest_between_cores(&self) -> [R; D] {
        let one = R::from_f64(1.0);
        let [u, v] = self.volumes.map(|volume| volume.half_axes[0]);
        let [uu, uv, vv] = [dot(u, u), dot(u, v), dot(v, v)];
        let [ud, vd] = [dot(u, self.between), dot(v, self.between)];
        let clamp = |numerator: R, denominator: R| {
            if !(denominator > R::ZERO) {
                return R::ZERO;
            }
            let x = numerator / denominator;
            if x > one {
                one
            } else if x < R::ZERO - one {
                R::ZERO - one
            } else {
                x
            }
        };
        let s = clamp(ud * vv - vd * uv, uu * vv - uv * uv);
        let t = clamp(s * uv - vd, vv);
        let s = clamp(t * uv + ud, uu);
        core::array::from_fn(|k| self.between[k] + t * v[k] - s * u[k])
    }
}

#[inline(always)]
fn sub<R: Real, const D: usize>(a: [R; D], b: [R; D]) -> [R; D] {
    core::array::from_fn(|k| a[k] - b[k])
}

#[inline(always)]
fn dot<R: Real, const D: usize>(a: [R; D], b: [R; D]) -> R {
    let mut sum = R::ZERO;
    for k in 0..D {
        sum = sum + a[k] * b[k];
    }
    sum
}
