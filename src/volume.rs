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
//! | with a cuboid | those of the world and of the cuboids, and from the segments of each to the centre of the other |
//! | with a half-space | its normal |
//!
//! Volumes that are apart have an axis that proves it, whichever it is and however inexactly it was found. So an axis that
//! was badly chosen costs a pair that need not be, and never one that must be. An axis so short that its square is lost to underflow
//! tells nothing apart.
//!
//! The idea of intervals along more axes than those of the world is that of k-DOPs (Klosowski and others 1998); axes that
//! are chosen for each pair are those of the separating-axis test (Gottschalk and others 1996). Both need a fraction of the
//! memory of a k-DOP, and tell more pairs apart.

use crate::aabb::Aabb;
use crate::real::Real;

mod room;
#[cfg(test)]
mod tests;

/// The bounding volume of a shape in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Volume<R, const D: usize> {
    pub(crate) kind: VolumeKind,
    /// The point and the ball. If the centre has a NaN, the volume meets all. Of a half-space it is a point on the plane.
    /// Except of a ball, the radius has room for what rounding may do to all of its numbers.
    pub(crate) ball: Ball<R, D>,
    /// The halves of the segments, as many as its kind has; zeros behind them.
    pub(crate) half_axes: [[R; D]; D],
}

/// A volume whose numbers are kept elsewhere.
#[derive(Clone, Copy, Debug)]
pub(crate) struct VolumeRef<'a, R, const D: usize> {
    pub(crate) kind: VolumeKind,
    pub(crate) ball: &'a Ball<R, D>,
    /// As many as its kind has.
    pub(crate) half_axes: &'a [[R; D]],
}

/// A ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ball<R, const D: usize> {
    pub(crate) center: [R; D],
    /// At least 0.
    pub(crate) radius: R,
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
    /// Of one of very many parts of a body. As [`Self::Box`]; and it stays that until the collider is read again, so that a box is
    /// handed over without a look at the collider.
    Part,
}

impl VolumeKind {
    /// How many half axes it has.
    pub(crate) fn axes<const D: usize>(self) -> usize {
        match self {
            Self::Box | Self::Ball | Self::Part => 0,
            Self::Capsule | Self::HalfSpace => 1,
            Self::Cuboid => D,
        }
    }
}

/// In rounding errors of the numbers that make two volumes: what their distance may be wrong by. The engine computes boxes and
/// contacts of its own, with other roundings, and must not find one between volumes that are apart.
const ROUNDINGS: f64 = 8.0;

impl<R: Real, const D: usize> Ball<R, D> {
    /// The same ball in the middle of a box, on each axis of which it must reach from side to side; otherwise one whose centre
    /// is NaN. A larger box is of more than the ball as it stands, say of its way to where it will be.
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
        // False if that cannot be told.
        let are_apart = dot(between, between) > at_least_exact(reach * reach);
        !are_apart
    }

    /// The sum of the changes of all numbers; NaN if that is not known.
    #[inline(always)]
    pub(crate) fn change_to(&self, other: &Self) -> R {
        sum_of_abs(sub(other.center, self.center)) + (other.radius - self.radius).abs()
    }

    /// The radius, loosened by what rounding may do to the numbers of a volume that has these half axes.
    #[inline(always)]
    fn loosened(&self, half_axes: &[[R; D]]) -> R {
        let extent = extent_of(half_axes.iter().copied());
        let size = (0..D).fold(self.radius, |size, k| {
            size + (self.center[k].abs() + extent[k])
        });
        self.radius + size * (R::from_f64(ROUNDINGS) * R::EPSILON)
    }
}

/// How far segments with these half axes reach along each axis of the world.
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
    /// A volume that meets all.
    pub(crate) const BOX: Self = Self {
        kind: VolumeKind::Box,
        ball: Ball {
            center: [R::NAN; D],
            radius: R::ZERO,
        },
        half_axes: [[R::ZERO; D]; D],
    };

    /// A part's volume, which meets all.
    pub(crate) const PART: Self = Self {
        kind: VolumeKind::Part,
        ..Self::BOX
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

    #[inline(always)]
    pub(crate) fn as_ref(&self) -> VolumeRef<'_, R, D> {
        VolumeRef {
            kind: self.kind,
            ball: &self.ball,
            half_axes: &self.half_axes[..self.kind.axes::<D>()],
        }
    }

    /// The volume that has these [numbers](VolumeRef::numbers), if there is one.
    #[cfg(feature = "serde-serialize")]
    pub(crate) fn of_numbers(kind: VolumeKind, numbers: &[R]) -> Option<Self> {
        let mut volume = Self { kind, ..Self::BOX };
        let Some((&radius, numbers)) = numbers.split_first() else {
            return Some(volume);
        };
        let is_boundless = matches!(kind, VolumeKind::Box | VolumeKind::Part);
        if is_boundless {
            return (radius == R::ZERO && numbers.is_empty()).then_some(volume);
        }
        (radius >= R::ZERO && radius.is_finite()).then(|| volume.ball.radius = radius)?;
        if numbers.is_empty() {
            return Some(volume);
        }
        let (center, numbers) = numbers.split_first_chunk()?;
        volume.ball.center = *center;
        let half_axes = volume.half_axes[..kind.axes::<D>()].as_flattened_mut();
        let is_complete = half_axes.len() == numbers.len();
        is_complete.then(|| half_axes.copy_from_slice(numbers))?;
        let is_finite = center.iter().chain(numbers).all(|x| x.is_finite());
        is_finite.then_some(volume)
    }

    /// The volume of a collider that has this box: a ball is in the middle of it, and other volumes stay where they are, but
    /// any must reach from side to side of the box on each axis; otherwise one that meets all.
    #[inline(always)]
    pub(crate) fn in_box(self, aabb: &Aabb<R, D>) -> Self {
        let ball = match self.kind {
            VolumeKind::Ball => self.ball.in_box(aabb),
            VolumeKind::Capsule | VolumeKind::Cuboid if !self.fills(aabb) => Ball {
                center: [R::NAN; D],
                ..self.ball
            },
            _ => self.ball,
        };
        Self { ball, ..self }
    }

    #[inline(always)]
    fn fills(&self, aabb: &Aabb<R, D>) -> bool {
        let Ball { center, radius } = self.ball;
        let extent = extent_of(self.as_ref().half_axes.iter().copied());
        (0..D).fold(true, |fills, k| {
            let reach = radius + extent[k];
            fills & (center[k] - reach <= aabb.mins[k]) & (aabb.maxs[k] <= center[k] + reach)
        })
    }

    /// Whether two volumes may meet, both loosened by half of `slack`: whether none of their axes tells them apart.
    #[cfg(test)]
    pub(crate) fn meets(&self, other: &Self, slack: R) -> bool {
        self.as_ref().meets(other.as_ref(), slack)
    }
}

impl<'a, R: Real, const D: usize> VolumeRef<'a, R, D> {
    /// Its radius, its centre and its half axes; as many of them as are finite, for some formats have no others. What is left out is
    /// that of a volume that meets all.
    #[cfg(feature = "serde-serialize")]
    pub(crate) fn numbers(self) -> Vec<R> {
        let Ball { center, radius } = *self.ball;
        let mut numbers = [&[radius], &center[..], self.half_axes.as_flattened()].concat();
        if !numbers.iter().all(|x| x.is_finite()) {
            numbers.truncate(usize::from(radius.is_finite()));
        }
        numbers
    }

    /// The sum of the changes of all numbers between two volumes of one kind: no point has moved by more. NaN if that is not known.
    /// Infinite for half-spaces, unless they are equal: where they are turned, points move by more the farther they are.
    #[inline(always)]
    pub(crate) fn change_to(self, other: Self) -> R {
        if self.kind == VolumeKind::HalfSpace {
            let is_equal = self.ball == other.ball && self.half_axes == other.half_axes;
            return if is_equal { R::ZERO } else { R::INFINITY };
        }
        // One sum for each axis, so that none waits for the other.
        let halves = self.half_axes.iter().zip(other.half_axes);
        let change = extent_of(halves.map(|(&from, &to)| sub(to, from)));
        self.ball.change_to(other.ball) + sum_of_abs(change)
    }

    /// Whether two volumes may meet, both loosened by half of `slack`: whether none of their axes tells them apart.
    #[inline(always)]
    pub(crate) fn meets(self, other: Self, slack: R) -> bool {
        use VolumeKind::{Ball, Box, Capsule, HalfSpace, Part};
        let both = Pair::of(self, other, slack);
        match (self.kind, other.kind) {
            (Box | Part, _) | (_, Box | Part) | (HalfSpace, HalfSpace) => true,
            (Ball, Ball) => self.ball.meets(other.ball, slack),
            (HalfSpace, _) => !both.is_behind_other([self, other]),
            (_, HalfSpace) => !both.is_behind_other([other, self]),
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

    /// Its radius, loosened by what rounding may do.
    #[inline(always)]
    fn radius(self) -> R {
        match self.kind {
            VolumeKind::Ball => self.ball.loosened(&[]),
            _ => self.ball.radius,
        }
    }

    /// Its first half axis; zeros if it has none.
    #[inline(always)]
    fn first_half_axis(self) -> [R; D] {
        self.half_axes.first().copied().unwrap_or([R::ZERO; D])
    }

    /// How far its segments reach from its centre along an axis, times the length of the axis.
    #[inline(always)]
    fn reach_of_segments(self, axis: [R; D]) -> R {
        self.half_axes
            .iter()
            .fold(R::ZERO, |sum, &half| sum + dot(half, axis).abs())
    }
}

/// Two volumes that may be apart.
struct Pair<'a, R, const D: usize> {
    volumes: [VolumeRef<'a, R, D>; 2],
    /// From the first centre to the second one.
    between: [R; D],
    /// The sum of what loosens them: radii and slack.
    reach: R,
}

impl<'a, R: Real, const D: usize> Pair<'a, R, D> {
    /// Two volumes, both loosened by half of `slack`.
    #[inline(always)]
    fn of(a: VolumeRef<'a, R, D>, b: VolumeRef<'a, R, D>, slack: R) -> Self {
        Self {
            between: sub(b.ball.center, a.ball.center),
            reach: a.radius() + b.radius() + slack,
            volumes: [a, b],
        }
    }

    /// Whether their intervals along an axis of any length do not meet, if their segments reach so far along it, times its length.
    /// False if that cannot be told.
    #[inline(always)]
    fn is_apart(&self, axis: [R; D], segments: R) -> bool {
        self.are_beyond_reach(dot(self.between, axis).abs(), axis, segments)
    }

    /// Whether a distance along an axis is more than the reach and that of segments; both are given times the length of the axis. False
    /// if that cannot be told.
    #[inline(always)]
    fn are_beyond_reach(&self, distance: R, axis: [R; D], segments: R) -> bool {
        let squared = dot(axis, axis);
        // An axis is no longer than all numbers of both volumes are together. So if its square is exact, the rounding that they are
        // loosened by is more than what underflow has done to any of the products.
        (squared >= R::LEAST_EXACT) & is_beyond(distance, self.reach * squared.sqrt() + segments)
    }

    /// Whether they are apart along an axis of the world.
    #[inline(always)]
    fn is_apart_in_world(&self) -> bool {
        let [a, b] = self.volumes;
        let mut reach = [self.reach; D];
        for half in a.half_axes.iter().chain(b.half_axes) {
            for k in 0..D {
                reach[k] = reach[k] + half[k].abs();
            }
        }
        (0..D).any(|k| is_beyond(self.between[k].abs(), reach[k]))
    }

    /// Whether they are apart along an axis of this one of them, if it is a cuboid.
    #[inline(always)]
    fn is_apart_by_sides(&self, [cuboid, other]: [VolumeRef<'a, R, D>; 2]) -> bool {
        cuboid.kind == VolumeKind::Cuboid
            && cuboid.half_axes.iter().any(|&axis| {
                // Its other axes are at right angles, or nearly so: what is left of them is in the rounding.
                self.is_apart(axis, dot(axis, axis) + other.reach_of_segments(axis))
            })
    }

    /// Whether a half-space is behind the other volume.
    fn is_behind_other(&self, [half_space, other]: [VolumeRef<'a, R, D>; 2]) -> bool {
        let normal = half_space.half_axes[0];
        let height = dot(sub(other.ball.center, half_space.ball.center), normal);
        self.are_beyond_reach(height, normal, other.reach_of_segments(normal))
    }

    /// Whether they are apart along the line to one centre from where the segments of the other volume, which is given, are nearest to
    /// it, or nearly so.
    #[inline(always)]
    fn is_apart_by_shortest(&self, volume: VolumeRef<'a, R, D>) -> bool {
        // To which side the line goes does not matter.
        let axis = volume.half_axes.iter().fold(self.between, |axis, &half| {
            let t = clamped(dot(self.between, half), dot(half, half));
            core::array::from_fn(|k| axis[k] - t * half[k])
        });
        let [a, b] = self.volumes;
        self.is_apart(axis, a.reach_of_segments(axis) + b.reach_of_segments(axis))
    }

    /// Whether two capsules are apart along the line of their centres, or between the points of their segments that are nearest to
    /// each other, or nearly so. A ball's segment is a point. Both tests share their products.
    #[inline(always)]
    fn cores_are_apart(&self) -> bool {
        let [u, v] = self.volumes.map(VolumeRef::first_half_axis);
        let between = self.between;
        let (dd, [ud, vd]) = (dot(between, between), [u, v].map(|half| dot(half, between)));
        if self.are_beyond_reach(dd, between, ud.abs() + vd.abs()) {
            return true;
        }
        let axis = nearest_points(between, [u, v], [ud, vd]);
        self.is_apart(axis, dot(u, axis).abs() + dot(v, axis).abs())
    }
}

/// Whether a sum of products that overflow may have made infinite is more than another one, whatever underflow has done to both. False if
/// that cannot be told.
#[inline(always)]
fn is_beyond<R: Real>(distance: R, reach: R) -> bool {
    (distance > at_least_exact(reach)) & distance.is_finite()
}

/// The number itself, NaN included, or the least one of which underflow has not taken any digits.
#[inline(always)]
fn at_least_exact<R: Real>(number: R) -> R {
    if number < R::LEAST_EXACT {
        R::LEAST_EXACT
    } else {
        number
    }
}

/// From the point of one segment to that of another one that are nearest to each other, or nearly so, if the centres are `between` apart;
/// `along` are the products of the half axes with that.
///
/// See Ericson, Real-Time Collision Detection, 5.1.9.
#[inline(always)]
fn nearest_points<R: Real, const D: usize>(
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

/// The number from -1 to 1 that is nearest to a quotient; 0 if the denominator is not positive.
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

#[inline(always)]
fn sub<R: Real, const D: usize>(a: [R; D], b: [R; D]) -> [R; D] {
    core::array::from_fn(|k| a[k] - b[k])
}

#[inline(always)]
fn dot<R: Real, const D: usize>(a: [R; D], b: [R; D]) -> R {
    (0..D).fold(R::ZERO, |sum, k| sum + a[k] * b[k])
}
