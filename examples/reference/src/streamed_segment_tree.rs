//! Streamed segment trees: segment trees that are walked while they are built, and never stored.
//!
//! Two boxes overlap on an axis exactly if one of them, taken as an interval, holds the low side of the other one, taken
//! as a point. A segment tree tells which points lie in which intervals. The points of a node are halved at an
//! approximate median (`median`); an interval goes to each half that it reaches. An interval that spans the whole
//! segment of a node holds all of its points: these two sets go on to the next axis together, in both roles. On the last
//! axis, and where few are left, both sets are sorted and scanned (`scan`).
//!
//! All sets are parts of two lists of boxes (`entry`), partitioned in place (`partition`).

mod entry;
mod median;
mod partition;
mod scan;
#[cfg(test)]
mod tests;

use crate::check_boxes;
use entry::{Border, Entry};
use median::Median;
use partition::partition;
use unisize::{Aabb, InvalidInput, PairFinder, Real};

/// CGAL's default.
const DEFAULT_CUTOFF: usize = 10;

/// After this many splits along one axis the rest is scanned, so that no input exhausts the stack. Exact halves would be
/// down to one box after 32.
const MAX_SPLITS: u32 = 96;

/// Streamed segment trees: Zomorodian and Edelsbrunner, *Fast software for box intersections* (2002), the algorithm of
/// CGAL's `box_self_intersection_d`, which the paper compares itself with as \[KMZ13\].
///
/// Computes in **O(n logᴰ n + pairs)** time for a fixed cutoff and boxes of any sizes anywhere, unless the medians, which
/// are estimated from random samples, are bad again and again: then O(n²). **O(n)** memory beside the pairs: the boxes,
/// twice.
///
/// Where there are fewer points or fewer intervals than the *cutoff*, they are scanned instead of being split further.
/// The default is 10, as in CGAL. Boxes of one size favour larger cutoffs: about 100 for 1,000 boxes, 500 for 10,000,
/// and 2000 from 100,000 on, which makes it two to three times as fast in 2D and four times in 3D. The cutoff changes
/// the order of the pairs, not their set.
///
/// One thing differs from CGAL: the low sides are ordered, and split, by coordinate *and index*. So equal coordinates
/// are split like any others, whereas CGAL scans what its median does not separate.
///
/// `D` must not be 0. The random numbers are the same in each run.
///
/// ```
/// use unisize::{Aabb, PairFinder};
/// use unisize_reference::StreamedSegmentTree;
///
/// let boxes = [
///     Aabb::new([0.0_f32, 0.0], [1.0, 1.0]),
///     Aabb::new([1.0, 0.5], [2.0, 1.5]), // Touches the first.
///     Aabb::new([5.0, 5.0], [6.0, 6.0]),
/// ];
/// let mut pairs = Vec::new();
/// StreamedSegmentTree::with_cutoff(2000).find_pairs(&boxes, &mut pairs)?;
/// assert_eq!(pairs, [[0, 1]]);
/// # Ok::<(), unisize::InvalidInput>(())
/// ```
#[derive(Clone, Debug)]
pub struct StreamedSegmentTree<R, const D: usize> {
    cutoff: usize,
    /// Scratch memory: the boxes as points, in the order of the walk.
    points: Vec<Entry<R, D>>,
    /// Scratch memory: the boxes as intervals, in an order of their own.
    intervals: Vec<Entry<R, D>>,
}

impl<R, const D: usize> Default for StreamedSegmentTree<R, D> {
    fn default() -> Self {
        Self::with_cutoff(DEFAULT_CUTOFF)
    }
}

impl<R, const D: usize> StreamedSegmentTree<R, D> {
    /// A kernel that scans where there are fewer points or fewer intervals than `cutoff`; with 0 it splits as far as
    /// possible.
    pub const fn with_cutoff(cutoff: usize) -> Self {
        Self {
            cutoff,
            points: Vec::new(),
            intervals: Vec::new(),
        }
    }
}

impl<R: Real, const D: usize> PairFinder<R, D> for StreamedSegmentTree<R, D> {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        const { assert!(D > 0, "boxes need an axis") };
        pairs.clear();
        check_boxes(boxes)?;
        let entry = |(aabb, index): (&Aabb<R, D>, u32)| Entry { aabb: *aabb, index };
        self.points.clear();
        self.points.extend(boxes.iter().zip(0..).map(entry));
        self.intervals.clone_from(&self.points);
        let mut walk = Walk {
            cutoff: self.cutoff,
            median: Median::new(),
            pairs,
        };
        // One role is enough here: of each pair, the box that begins first is among the intervals too.
        walk.root(&mut self.points, &mut self.intervals, D - 1);
        Ok(())
    }
}

/// A walk through the trees.
struct Walk<'a> {
    cutoff: usize,
    median: Median,
    pairs: &'a mut Vec<[u32; 2]>,
}

impl Walk<'_> {
    /// Reports the pairs of a point and an interval that overlap on all axes up to `axis`, where the interval must
    /// hold the low side of the point.
    fn root<R: Real, const D: usize>(
        &mut self,
        points: &mut [Entry<R, D>],
        intervals: &mut [Entry<R, D>],
        axis: usize,
    ) {
        let everything = Border::everything();
        self.node(points, intervals, everything, axis, MAX_SPLITS);
    }

    /// The same where all points begin in `from..to`, with this many splits left.
    fn node<R: Real, const D: usize>(
        &mut self,
        points: &mut [Entry<R, D>],
        intervals: &mut [Entry<R, D>],
        [from, to]: [Border<R>; 2],
        axis: usize,
        splits: u32,
    ) {
        if points.is_empty() || intervals.is_empty() {
            return;
        }
        if axis == 0 {
            return scan::one_way(points, intervals, self.pairs);
        }
        if points.len().min(intervals.len()) < self.cutoff || splits == 0 {
            return scan::both_ways(points, intervals, axis, self.pairs);
        }
        let spans = |i: &Entry<R, D>| i.low(axis).precedes(from) & i.reaches(to, axis);
        let (spanning, rest) = partition(intervals, spans);
        if !spanning.is_empty() {
            self.root(points, spanning, axis - 1);
            self.root(spanning, points, axis - 1);
        }
        let middle = self.median.of_lows(points, axis);
        let (left, right) = partition(points, |p| p.low(axis).precedes(middle));
        if left.is_empty() {
            // The sample's median is the least of all: there are hardly any points.
            return scan::both_ways(right, rest, axis, self.pairs);
        }
        let (begins_left, _) = partition(rest, |i| i.low(axis).precedes(middle));
        self.node(left, begins_left, [from, middle], axis, splits - 1);
        let (ends_right, _) = partition(rest, |i| i.reaches(middle, axis));
        self.node(right, ends_right, [middle, to], axis, splits - 1);
    }
}
