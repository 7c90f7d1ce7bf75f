//! The axis-aligned box.

use core::array;

use crate::real::Real;

/// An axis-aligned bounding box in `D` dimensions, closed on every side.
///
/// `mins[k]` and `maxs[k]` are its least and greatest coordinates on axis `k`, in the length unit of the scene. Sides may be infinite, as
/// those of a ground plane; see [`Aabb::is_valid`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize),
    serde(bound(
        serialize = "[R; D]: serde::Serialize",
        deserialize = "[R; D]: serde::Deserialize<'de>"
    ))
)]
pub struct Aabb<R, const D: usize> {
    /// The least coordinate on each axis.
    pub mins: [R; D],
    /// The greatest coordinate on each axis.
    pub maxs: [R; D],
}

impl<R: Real, const D: usize> Aabb<R, D> {
    /// The placeholder for no box: all NaN, so that it is not valid and overlaps nothing.
    pub(crate) const ABSENT: Self = Self::new([R::NAN; D], [R::NAN; D]);

    /// The box around nothing: inverted on every axis, so that a box [around](Self::around) it and another is the other.
    pub(crate) const EMPTY: Self = Self::new([R::INFINITY; D], [R::NEG_INFINITY; D]);

    /// Returns the box between two corners.
    #[inline]
    pub const fn new(mins: [R; D], maxs: [R; D]) -> Self {
        Self { mins, maxs }
    }

    /// Returns whether the two closed boxes share a point. Boxes that only touch do.
    ///
    /// The result is exact, because it compares the given numbers without any arithmetic. It defines overlap for every
    /// [`PairFinder`](crate::PairFinder). An invalid box (see [`Aabb::is_valid`]) whose sides are NaN on some axis overlaps nothing.
    ///
    /// ```
    /// use unisize::Aabb;
    ///
    /// let square = Aabb::new([0.0, 0.0], [1.0, 1.0]);
    /// assert!(square.intersects(&Aabb::new([1.0, 1.0], [2.0, 2.0]))); // In a corner.
    /// assert!(!square.intersects(&Aabb::new([1.0, 1.1], [2.0, 2.0])));
    /// ```
    #[inline]
    pub fn intersects(&self, other: &Self) -> bool {
        let mut intersect = true;
        for k in 0..D {
            intersect &= (self.mins[k] <= other.maxs[k]) & (other.mins[k] <= self.maxs[k]);
        }
        intersect
    }

    /// Returns whether `other` lies inside this box, sides included.
    #[inline]
    pub fn contains(&self, other: &Self) -> bool {
        let mut contains = true;
        for k in 0..D {
            contains &= (self.mins[k] <= other.mins[k]) & (other.maxs[k] <= self.maxs[k]);
        }
        contains
    }

    /// Returns the box with every side moved outward by `margin` (a length, at least 0).
    ///
    /// Where coordinates are large, rounding may remove the margin. A box with a margin contains the original box until that has moved by
    /// more than the margin; until then, a program need not search for its pairs again:
    ///
    /// ```
    /// use unisize::Aabb;
    ///
    /// let held = Aabb::new([0.0, 0.0], [1.0, 1.0]).loosened(0.25);
    /// assert_eq!(held, Aabb::new([-0.25, -0.25], [1.25, 1.25]));
    /// assert!(held.contains(&Aabb::new([0.2, 0.0], [1.2, 1.0])));
    /// assert!(!held.contains(&Aabb::new([0.3, 0.0], [1.3, 1.0])));
    /// ```
    #[inline]
    pub fn loosened(&self, margin: R) -> Self {
        Self {
            mins: self.mins.map(|x| x - margin),
            maxs: self.maxs.map(|x| x + margin),
        }
    }

    /// Returns the smallest box around two.
    pub(crate) fn around(&self, other: &Self) -> Self {
        Self {
            mins: array::from_fn(|k| min(self.mins[k], other.mins[k])),
            maxs: array::from_fn(|k| max(self.maxs[k], other.maxs[k])),
        }
    }

    /// Returns the part of a valid box that lies within another.
    #[inline]
    pub(crate) fn within(&self, other: &Self) -> Option<Self> {
        self.intersects(other).then(|| Self {
            mins: array::from_fn(|k| max(self.mins[k], other.mins[k])),
            maxs: array::from_fn(|k| min(self.maxs[k], other.maxs[k])),
        })
    }

    /// Returns whether no coordinate is NaN and `mins <= maxs` on every axis. Kernels refuse every other box as
    /// [`InvalidInput`](crate::InvalidInput).
    ///
    /// ```
    /// use unisize::Aabb;
    ///
    /// let ground = Aabb::new([f32::NEG_INFINITY, f32::NEG_INFINITY], [f32::INFINITY, 0.0]);
    /// assert!(ground.is_valid());
    /// assert!(!Aabb::new([0.0, f32::NAN], [1.0, 1.0]).is_valid());
    /// assert!(!Aabb::new([0.0, 1.0], [1.0, 0.0]).is_valid());
    /// ```
    #[inline]
    pub fn is_valid(&self) -> bool {
        let mut valid = true;
        for k in 0..D {
            // Also false for NaN.
            valid &= self.mins[k] <= self.maxs[k];
        }
        valid
    }

    /// Returns whether the box is valid, and some side of it is infinite.
    #[inline]
    pub(crate) fn is_unbounded(&self) -> bool {
        let mut finite = true;
        for k in 0..D {
            finite &= self.mins[k].is_finite() & self.maxs[k].is_finite();
        }
        !finite && self.is_valid()
    }
}

/// Returns the lesser of two numbers; the second one if they cannot be compared.
#[inline(always)]
pub(crate) fn min<R: Real>(a: R, b: R) -> R {
    if a < b { a } else { b }
}

/// Returns the greater of two numbers; the second one if they cannot be compared.
#[inline(always)]
pub(crate) fn max<R: Real>(a: R, b: R) -> R {
    if a > b { a } else { b }
}
