//! Pairs by a segment tree that is not stored: boxes stream through its nodes.
//!
//! No grid helps where boxes as long as the world pass each other without touching. This search takes **O(n logᴰ n + pairs)** time for
//! boxes of any sizes in any places, and **O(n)** memory for each thread. It reads each box many times, so it is slower where a grid does help.
//!
//! If two intervals overlap, one of them holds the beginning of the other. So on one axis some boxes count as *intervals* and others by
//! their `mins` as *points*, and then the other way round. Each node of the tree halves the points. An interval that holds all points of
//! a node is done with that axis, and is compared with them on the next one; this happens in at most two nodes of each level. Other
//! intervals go down to the halves that they reach.
//!
//! Source: Zomorodian and Edelsbrunner, "Fast software for box intersections", 2000.

use core::cmp::Ordering;

use super::choose::sample_of;
use super::entry::{Entry, Owner};
use super::search::Search;
use super::worker::Worker;
use crate::parallel::{Section, join};
use crate::real::Real;
use crate::tuning::kernel::{EFFORT_SAMPLE, LEAF_UP_TO};
use crate::tuning::prices::LOOKED_UP;

impl<R: Real, const D: usize> Search<'_, R, D> {
    /// Appends the pairs between two lists of members, in order. **O(n logᴰ n + pairs log pairs)**.
    pub(super) fn match_lists(&mut self, left: &[u32], right: &[u32]) {
        let boxes = self.boxes;
        let entry = |&i: &u32| Entry {
            aabb: boxes[i as usize],
            owner: Owner(i),
        };
        let lists = [left, right].map(|members| members.iter().map(entry).collect::<Vec<_>>());
        let axes = axes_by_overlap::<R, D>(&lists[0], &lists[1]);
        let [mut left, mut right] = lists.clone();
        let section = Section::of(left.len() + right.len(), LOOKED_UP);
        let sort = |list: &mut [Entry<R, D>]| list.sort_unstable_by(|a, b| order(a, b, axes[0]));
        join(|| sort(&mut left), || sort(&mut right));
        let mut parts = Vec::new();
        for (intervals, points) in [(&lists[1], &mut left), (&lists[0], &mut right)] {
            let points_a_part = points.len().div_ceil(section.parts()).max(1);
            let points = points.chunks_mut(points_a_part);
            parts.extend(points.map(|points| (intervals, points)));
        }
        let first = self.pairs.len();
        self.collect(section, parts, |(intervals, points), worker| {
            descend(&mut intervals.to_vec(), points, &axes, worker);
        });
        // The number of parts makes no difference.
        self.pairs[first..].sort_unstable();
    }
}

/// Emits the pairs among entries. Reorders them.
pub(super) fn match_all<R: Real, const D: usize>(entries: &mut [Entry<R, D>], worker: &mut Worker) {
    let axes = axes_by_overlap(entries, entries);
    stab(&mut entries.to_vec(), entries, &axes, worker);
}

/// The axes, those first on which fewer pairs of a sample overlap: an axis that separates most boxes leaves few for the next one.
fn axes_by_overlap<R: Real, const D: usize>(
    left: &[Entry<R, D>],
    right: &[Entry<R, D>],
) -> [usize; D] {
    let [left, right] = [left, right].map(|list| -> Vec<_> {
        let sample = sample_of(list, EFFORT_SAMPLE);
        sample.map(|entry| entry.aabb).collect()
    });
    let overlaps = |k: usize| {
        let pairs = left.iter().flat_map(|a| right.iter().map(move |b| (a, b)));
        let overlap = pairs.filter(|(a, b)| (a.mins[k] <= b.maxs[k]) & (b.mins[k] <= a.maxs[k]));
        overlap.count()
    };
    let mut axes = core::array::from_fn(|k| k);
    axes.sort_by_cached_key(|&k| overlaps(k));
    axes
}

/// Emits each pair of an interval and a point that it holds on the first of the axes, if they overlap on the others.
fn stab<R: Real, const D: usize>(
    intervals: &mut [Entry<R, D>],
    points: &mut [Entry<R, D>],
    axes: &[usize],
    worker: &mut Worker,
) {
    if let Some(&axis) = axes.first() {
        worker.tally.compared += points.len() as u64;
        points.sort_unstable_by(|a, b| order(a, b, axis));
        descend(intervals, points, axes, worker);
    } else {
        for i in intervals {
            for point in &*points {
                worker.emit_one(i.owner, point.owner, true);
            }
            if worker.is_over() {
                return;
            }
        }
    }
}

/// The same at a node of the tree of one axis. The points are in order.
fn descend<R: Real, const D: usize>(
    intervals: &mut [Entry<R, D>],
    points: &mut [Entry<R, D>],
    axes: &[usize],
    worker: &mut Worker,
) {
    let (axis, others) = (axes[0], &axes[1..]);
    let [Some(&first), Some(&last)] = [points.first(), points.last()] else {
        return;
    };
    if worker.is_over() {
        return;
    }
    worker.tally.compared += intervals.len() as u64;
    let count = partition(intervals, |i| holds(i, &last, &first, axis));
    let intervals = &mut intervals[..count];
    if intervals.len().min(points.len()) <= LEAF_UP_TO {
        for i in intervals {
            let first = points.partition_point(|point| order(point, i, axis).is_le());
            let reached = points[first..].iter();
            for point in reached.take_while(|point| point.aabb.mins[axis] <= i.aabb.maxs[axis]) {
                worker.tally.compared += 1;
                worker.emit_one(i.owner, point.owner, i.aabb.intersects(&point.aabb));
            }
        }
        return;
    }
    let count = partition(intervals, |i| holds(i, &first, &last, axis));
    let (whole, partial) = intervals.split_at_mut(count);
    let (low, high) = points.split_at_mut(points.len() / 2);
    descend(partial, low, axes, worker);
    descend(partial, high, axes, worker);
    // At the end, for it reorders the points.
    if !whole.is_empty() {
        stab(whole, points, others, worker);
        if !others.is_empty() {
            stab(points, whole, others, worker);
        }
    }
}

/// Whether a box begins before another one does, and ends after a third one begins.
#[inline(always)]
fn holds<R: Real, const D: usize>(
    aabb: &Entry<R, D>,
    begins_before: &Entry<R, D>,
    reaches: &Entry<R, D>,
    axis: usize,
) -> bool {
    let [from, to] = [aabb, begins_before].map(|entry| entry.aabb.mins[axis]);
    let is_first = aabb.owner.index() < begins_before.owner.index();
    ((from < to) | ((from == to) & is_first)) & (aabb.aabb.maxs[axis] >= reaches.aabb.mins[axis])
}

/// The order in which two boxes begin on an axis, the same each time also if they begin at one place.
fn order<R: Real, const D: usize>(a: &Entry<R, D>, b: &Entry<R, D>, axis: usize) -> Ordering {
    let [from_a, from_b] = [a, b].map(|entry| entry.aabb.mins[axis]);
    // Valid boxes have no NaN.
    let order = from_a.partial_cmp(&from_b).unwrap_or(Ordering::Equal);
    order.then_with(|| a.owner.index().cmp(&b.owner.index()))
}

/// Moves the items of which something is true to the front, and returns their number.
fn partition<T>(items: &mut [T], is_true: impl Fn(&T) -> bool) -> usize {
    let (mut low, mut high) = (0, items.len());
    loop {
        while low < high && is_true(&items[low]) {
            low += 1;
        }
        while low < high && !is_true(&items[high - 1]) {
            high -= 1;
        }
        if low == high {
            return low;
        }
        items.swap(low, high - 1);
    }
}
