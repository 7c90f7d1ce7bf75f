//! Sorting two sets along the first axis, and finding their pairs by scanning both.

use super::entry::Entry;
use crate::ordered;
use unisize::Real;

/// Appends the pairs of a point and an interval that holds its low side on the first axis; nothing else is tested.
///
/// Computes in **O(n log n + pairs)**.
pub(super) fn one_way<R: Real, const D: usize>(
    points: &mut [Entry<R, D>],
    intervals: &mut [Entry<R, D>],
    pairs: &mut Vec<[u32; 2]>,
) {
    sort(points);
    sort(intervals);
    let mut points = &points[..];
    for i in intervals.iter() {
        let low = i.low(0);
        let before = points.iter().take_while(|p| !low.precedes(p.low(0)));
        points = &points[before.count()..];
        let held = points.iter().take_while(|p| i.reaches(p.low(0), 0));
        pairs.extend(held.map(|p| ordered(p.index, i.index)));
    }
}

/// Appends the pairs of a point and an interval that overlap on all axes up to `axis`, where the interval must hold the
/// low side of the point.
///
/// Computes in **O(n log n + c)**, where c is the number of pairs that overlap on the first axis, at worst all of them.
pub(super) fn both_ways<R: Real, const D: usize>(
    points: &mut [Entry<R, D>],
    intervals: &mut [Entry<R, D>],
    axis: usize,
    pairs: &mut Vec<[u32; 2]>,
) {
    sort(points);
    sort(intervals);
    let mut report = |p: &Entry<R, D>, i: &Entry<R, D>| {
        if p.overlaps_on(i, 1..axis) & i.holds_low_of(p, axis) {
            pairs.push(ordered(p.index, i.index));
        }
    };
    let (mut points, mut intervals) = (&points[..], &intervals[..]);
    while let ([p, later_points @ ..], [i, later_intervals @ ..]) = (points, intervals) {
        if i.low(0).precedes(p.low(0)) {
            let held = points.iter().take_while(|p| i.reaches(p.low(0), 0));
            held.for_each(|p| report(p, i));
            intervals = later_intervals;
        } else {
            let held = intervals.iter().take_while(|i| p.reaches(i.low(0), 0));
            held.for_each(|i| report(p, i));
            points = later_points;
        }
    }
}

/// Sorts by where the boxes begin on the first axis.
fn sort<R: Real, const D: usize>(entries: &mut [Entry<R, D>]) {
    entries.sort_unstable_by(|a, b| {
        let (a, b) = (a.low(0), b.low(0));
        b.precedes(a).cmp(&a.precedes(b))
    });
}
