//! What the lists hold, and how places on an axis are ordered.

use core::ops::Range;
use unisize::{Aabb, Real};

/// A box, with its index in the caller's list.
///
/// Aligned so that its size is an even number of words. 28 bytes would be moved as two overlapping halves, which wait
/// for each other wherever an entry is moved twice in a row; in 3D, partitions would take twice as long.
#[derive(Clone, Copy, Debug)]
#[repr(align(8))]
pub(super) struct Entry<R, const D: usize> {
    pub(super) aabb: Aabb<R, D>,
    pub(super) index: u32,
}

/// Where a box begins on an axis. Of boxes that begin at the same number, the one with the smaller index comes first, so
/// no two begin at the same place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Border<R> {
    at: R,
    index: u32,
}

impl<R: Real> Border<R> {
    /// Nothing begins before the first, and everything before the second: indices are smaller.
    pub(super) fn everything() -> [Self; 2] {
        [(f64::NEG_INFINITY, 0), (f64::INFINITY, u32::MAX)].map(|(at, index)| Self {
            at: R::from_f64(at),
            index,
        })
    }

    /// Whether this comes before the other one.
    #[inline(always)]
    pub(super) fn precedes(self, other: Self) -> bool {
        // No branch: which of the two comes first is unpredictable.
        (self.at < other.at) | ((self.at == other.at) & (self.index < other.index))
    }
}

impl<R: Real, const D: usize> Entry<R, D> {
    /// Where the box begins.
    #[inline(always)]
    pub(super) fn low(&self, axis: usize) -> Border<R> {
        Border {
            at: self.aabb.mins[axis],
            index: self.index,
        }
    }

    /// Whether the box ends there or later. Boxes are closed, so only the number counts.
    #[inline(always)]
    pub(super) fn reaches(&self, place: Border<R>, axis: usize) -> bool {
        self.aabb.maxs[axis] >= place.at
    }

    /// Whether the box, as an interval, holds the low side of the other one. Of two boxes that overlap exactly one does;
    /// no box holds its own low side.
    #[inline(always)]
    pub(super) fn holds_low_of(&self, point: &Self, axis: usize) -> bool {
        let low = point.low(axis);
        self.low(axis).precedes(low) & self.reaches(low, axis)
    }

    /// Whether the two overlap on these axes.
    #[inline(always)]
    pub(super) fn overlaps_on(&self, other: &Self, axes: Range<usize>) -> bool {
        let (a, b) = (&self.aabb, &other.aabb);
        let mut overlaps = true;
        for k in axes {
            overlaps &= (a.mins[k] <= b.maxs[k]) & (b.mins[k] <= a.maxs[k]);
        }
        overlaps
    }
}
