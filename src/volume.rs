//! Bounding volumes of shapes, which separate pairs whose boxes overlap and whose shapes cannot meet.
//!
//! The paper goes from two dimensions to three by one more interval test. This module continues to as many axes as a pair needs. A volume is the
//! Minkowski sum of a point, a ball and up to `D` segments, so its interval along *any* axis `n` is `c · n ± (r |n| + Σ |h · n|)`. Two
//! volumes are apart if their intervals along one of these axes do not meet:
//!
//! | pair | axes |
//! |---|---|
//! | balls | the line of centers |
//! | balls and capsules | the line of centers, and the line between the closest points of their core segments |
//! | with a cuboid | the axes of the world and of the cuboids, and the line from the closest point of each volume's segments to the other's center |
//! | with a half-space | its normal |
//!
//! Any axis whose intervals do not meet proves that the volumes are apart, however inexactly the axis was computed. So a badly chosen axis may
//! cost a superfluous pair, and never loses a necessary one. An axis so short that its square underflows proves nothing.
//!
//! Intervals along more axes are the idea of k-DOPs (Klosowski and others 1998), axes for each pair that of Gottschalk and others (1996).

use crate::aabb::Aabb;
use crate::real::Real;
use separating_axes::Pair;

mod separating_axes;
#[cfg(test)]
mod tests;

/// The bounding volume of a shape in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Volume<R, const D: usize> {
    pub(crate) kind: VolumeKind,
    /// The point and the ball. If the center has a NaN, the volume meets all others. The center of a half-space is a point on its plane. Except
    /// for a ball, the radius includes a bound on the rounding errors of all numbers.
    pub(crate) ball: Ball<R, D>,
    /// Half of each segment, as many as its kind has, followed by zeros.
    pub(crate) half_axes: [[R; D]; D],
}

/// A borrowed volume.
#[derive(Clone, Copy, Debug)]
pub(crate) struct VolumeRef<'a, R, const D: usize> {
    pub(crate) kind: VolumeKind,
    pub(crate) ball: &'a Ball<R, D>,
    /// As many as the kind has.
    pub(crate) half_axes: &'a [[R; D]],
}

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ball<R, const D: usize> {
    pub(crate) center: [R; D],
    /// At least 0.
    pub(crate) radius: R,
}

/// The kind of a volume.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) enum VolumeKind {
    /// Only the box is known: the volume meets all others.
    Box,
    Ball,
    /// One segment.
    Capsule,
    /// `D` segments, at right angles.
    Cuboid,
    /// All points behind a plane, whose unit normal is the first half axis.
    HalfSpace,
    /// Like [`Self::Box`], and it stays so until the collider is read again. For one of very many colliders of a body, or a body with soft CCD.
    BoxUntilRead,
}

impl VolumeKind {
    /// The number of half axes.
    pub(crate) fn axes<const D: usize>(self) -> usize {
        match self {
            Self::Box | Self::Ball | Self::BoxUntilRead => 0,
            Self::Capsule | Self::HalfSpace => 1,
            Self::Cuboid => D,
        }
    }
}

/// A bound on the error of the distance of two volumes, in rounding errors of their numbers. The engine computes boxes and contacts with other
/// rounding errors, and must not find a contact between volumes that are apart.
const ROUNDINGS: f64 = 8.0;

/// The most by which the norm squared of a rotation or of a normal may be off from 1, in rounding errors, so that it turns a volume. Where Rapier
/// renormalizes, a body's is off by up to 3, and by up to 5 once it is multiplied by that of a collider relative to its body.
///
/// If a rotation scales by `1 + off`, Parry, in the frame of the shape, neither scales the shape nor its radius and that of the other, but
/// the way between both. Against the volumes, the sides of the shape are off by up to `2 off` of their length, which [`Volume::stretched`] adds,
/// and all radii by `off`, which is within [`ROUNDINGS`] of the other volume's size.
pub(crate) const MOST_OFF_UNIT: f64 = ROUNDINGS;

impl<R: Real, const D: usize> Ball<R, D> {
    /// The ball in the middle of a box. If the box is larger than the ball on some axis, the center is NaN: such a box may contain the ball's
    /// predicted motion.
    #[inline(always)]
    pub(crate) fn in_box(self, aabb: &Aabb<R, D>) -> Self {
        let half = R::from_f64(0.5);
        let center = core::array::from_fn(|k| (aabb.mins[k] + aabb.maxs[k]) * half);
        let ball = Self { center, ..self };
        let diameter = ball.loosened(&[]) * R::from_f64(2.0);
        let mut fits = true;
        for k in 0..D {
            fits &= aabb.maxs[k] - aabb.mins[k] <= diameter;
        }
        Self {
            center: if fits { center } else { [R::NAN; D] },
            ..self
        }
    }

    /// Whether two balls may meet, both loosened by half of `slack`.
    #[inline(always)]
    pub(crate) fn meets(&self, other: &Self, slack: R) -> bool {
        let between = sub(other.center, self.center);
        let reach = self.loosened(&[]) + other.loosened(&[]) + slack;
        // False for NaN.
        let are_apart = dot(between, between) > at_least_exact(reach * reach);
        !are_apart
    }

    /// The sum of the changes of all numbers; NaN if it is unknown.
    #[inline(always)]
    pub(crate) fn change_to(&self, other: &Self) -> R {
        sum_of_abs(sub(other.center, self.center)) + (other.radius - self.radius).abs()
    }

    /// The radius, plus a bound on the rounding errors of a volume with this ball and these half axes.
    #[inline(always)]
    fn loosened(&self, half_axes: &[[R; D]]) -> R {
        let extent = extent_of(half_axes.iter().copied());
        let size = (0..D).fold(self.radius, |size, k| {
            size + (self.center[k].abs() + extent[k])
        });
        self.radius + size * (R::from_f64(ROUNDINGS) * R::EPSILON)
    }
}

/// The half extents of the box around segments with these half axes.
#[inline(always)]
fn extent_of<R: Real, const D: usize>(half_axes: impl Iterator<Item = [R; D]>) -> [R; D] {
    half_axes.fold([R::ZERO; D], |extent, half| {
        core::array::from_fn(|k| extent[k] + half[k].abs())
    })
}

/// The sum of the absolute values.
#[inline(always)]
fn sum_of_abs<R: Real, const D: usize>(vector: [R; D]) -> R {
    vector.iter().fold(R::ZERO, |sum, x| sum + x.abs())
}

impl<R: Real, const D: usize> Volume<R, D> {
    /// A volume that meets all others.
    pub(crate) const BOX: Self = Self {
        kind: VolumeKind::Box,
        ball: Ball {
            center: [R::NAN; D],
            radius: R::ZERO,
        },
        half_axes: [[R::ZERO; D]; D],
    };

    /// A negative radius counts as 0.
    #[inline(always)]
    pub(crate) fn new(kind: VolumeKind, center: [R; D], radius: R, half_axes: &[[R; D]]) -> Self {
        let radius = if radius < R::ZERO { R::ZERO } else { radius };
        let mut volume = Self {
            kind,
            ball: Ball { center, radius },
            ..Self::BOX
        };
        let half_axes = &half_axes[..kind.axes::<D>()];
        volume.half_axes[..half_axes.len()].copy_from_slice(half_axes);
        if kind != VolumeKind::Ball {
            volume.ball.radius = volume.ball.loosened(half_axes);
        }
        volume
    }

    /// Loosened for a rotation whose norm squared is `off` from 1.
    #[inline(always)]
    pub(crate) fn stretched(mut self, off: R) -> Self {
        // An infinite radius times 0 would be NaN.
        if off > R::ZERO {
            let extent = extent_of(self.as_ref().half_axes.iter().copied());
            let size = sum_of_abs(extent) + self.ball.radius;
            self.ball.radius = self.ball.radius + size * (off + off);
        }
        self
    }

    #[inline(always)]
    pub(crate) fn as_ref(&self) -> VolumeRef<'_, R, D> {
        VolumeRef {
            kind: self.kind,
            ball: &self.ball,
            half_axes: &self.half_axes[..self.kind.axes::<D>()],
        }
    }

    /// The volume with these [numbers](VolumeRef::numbers), if they are valid.
    #[cfg(feature = "serde-serialize")]
    pub(crate) fn of_numbers(kind: VolumeKind, numbers: &[R]) -> Option<Self> {
        let mut volume = Self { kind, ..Self::BOX };
        let Some((&radius, rest)) = numbers.split_first() else {
            return Some(volume);
        };
        volume.ball.radius = radius;
        if !rest.is_empty() {
            let (center, rest) = rest.split_first_chunk()?;
            volume.ball.center = *center;
            let half_axes = volume.half_axes[..kind.axes::<D>()].as_flattened_mut();
            (half_axes.len() == rest.len()).then(|| half_axes.copy_from_slice(rest))?;
        }
        let is_boundless = matches!(kind, VolumeKind::Box | VolumeKind::BoxUntilRead);
        let are_of_kind = !is_boundless || numbers == [R::ZERO];
        let are_valid = radius >= R::ZERO && numbers.iter().all(|x| x.is_finite());
        (are_of_kind && are_valid).then_some(volume)
    }

    /// Whether two volumes may meet, each loosened by half of `slack`: whether none of their axes separates them.
    #[cfg(test)]
    pub(crate) fn meets(&self, other: &Self, slack: R) -> bool {
        self.as_ref().meets(other.as_ref(), slack)
    }
}

impl<'a, R: Real, const D: usize> VolumeRef<'a, R, D> {
    /// The radius, the center and the half axes. If they are not all finite, the radius alone if it is, and otherwise nothing, because some
    /// formats only have finite numbers. Without a center a volume meets all others.
    #[cfg(feature = "serde-serialize")]
    pub(crate) fn numbers(self) -> Vec<R> {
        let Ball { center, radius } = *self.ball;
        let mut numbers = [&[radius], &center[..], self.half_axes.as_flattened()].concat();
        if !numbers.iter().all(|x| x.is_finite()) {
            numbers.truncate(usize::from(radius.is_finite()));
        }
        numbers
    }

    /// The sum of the changes of all numbers between two volumes of one kind, which bounds the motion of every point; NaN if it is unknown. It is
    /// infinite for half-spaces that differ, because a rotation moves distant points farther.
    #[inline(always)]
    pub(crate) fn change_to(self, other: Self) -> R {
        if self.kind == VolumeKind::HalfSpace {
            let is_equal = self.ball == other.ball && self.half_axes == other.half_axes;
            return if is_equal { R::ZERO } else { R::INFINITY };
        }
        // Independent sums for each axis, so that the processor can overlap them.
        let halves = self.half_axes.iter().zip(other.half_axes);
        let change = extent_of(halves.map(|(&from, &to)| sub(to, from)));
        self.ball.change_to(other.ball) + sum_of_abs(change)
    }

    /// Whether two volumes may meet, each loosened by half of `slack`: whether none of their axes separates them.
    #[inline(always)]
    pub(crate) fn meets(self, other: Self, slack: R) -> bool {
        use VolumeKind::{Ball, Box, BoxUntilRead, Capsule, HalfSpace};
        let both = Pair::of(self, other, slack);
        match (self.kind, other.kind) {
            (Box | BoxUntilRead, _) | (_, Box | BoxUntilRead) | (HalfSpace, HalfSpace) => true,
            (Ball, Ball) => self.ball.meets(other.ball, slack),
            (HalfSpace, _) => !both.is_in_front([self, other]),
            (_, HalfSpace) => !both.is_in_front([other, self]),
            (Ball | Capsule, Ball | Capsule) => !both.cores_are_apart(),
            _ => {
                !(both.is_apart_in_world()
                    || both.is_apart_by_sides([self, other])
                    || both.is_apart_by_sides([other, self])
                    || both.is_apart_by_shortest(self)
                    || both.is_apart_by_shortest(other))
            }
        }
    }

    /// The radius, plus a bound on the rounding errors.
    #[inline(always)]
    fn radius(self) -> R {
        match self.kind {
            VolumeKind::Ball => self.ball.loosened(&[]),
            _ => self.ball.radius,
        }
    }

    /// The reach of the segments from the center along an axis, times the length of the axis.
    #[inline(always)]
    fn reach_of_segments(self, axis: [R; D]) -> R {
        self.half_axes
            .iter()
            .fold(R::ZERO, |sum, &half| sum + dot(half, axis).abs())
    }
}

/// The maximum of a number and the smallest one that has lost no digits to underflow; NaN for NaN.
#[inline(always)]
fn at_least_exact<R: Real>(number: R) -> R {
    if number < R::LEAST_EXACT {
        R::LEAST_EXACT
    } else {
        number
    }
}

#[inline(always)]
fn sub<R: Real, const D: usize>(a: [R; D], b: [R; D]) -> [R; D] {
    core::array::from_fn(|k| a[k] - b[k])
}

#[inline(always)]
fn dot<R: Real, const D: usize>(a: [R; D], b: [R; D]) -> R {
    (0..D).fold(R::ZERO, |sum, k| sum + a[k] * b[k])
}
