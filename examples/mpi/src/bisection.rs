//! Space, cut in two again and again until each process has a region: recursive coordinate bisection (Berger and Bokhari, 1987).

use std::ops::Range;
use unisize::Aabb;

/// A tree of cuts. The regions of its leaves partition space, points at infinity included.
pub(crate) enum Bisection<const D: usize> {
    /// A process, and its region, of which finite `maxs` are not a part.
    Leaf(usize, Aabb<f64, D>),
    /// Points that have less than this finite number on this axis are on the first side, all others on the second.
    Cut(usize, f64, Box<[Self; 2]>),
}

impl<const D: usize> Bisection<D> {
    /// Regions of a `space` for these processes, each with about as many of the points, which are finite. Equal points in equal order give
    /// equal regions; points that coincide stay together. **O(points · log points · log processes)**.
    pub(crate) fn new(points: &mut [[f64; D]], owners: Range<usize>, space: Aabb<f64, D>) -> Self {
        if owners.len() <= 1 {
            return Self::Leaf(owners.start, space);
        }
        let half = owners.len() / 2;
        let axis = widest_axis(points);
        let (at, below) = cut(points, axis, points.len() * half / owners.len());
        let (first, second) = points.split_at_mut(below);
        let [mut below, mut above] = [space; 2];
        // A cut without points may lie outside.
        below.maxs[axis] = at.min(space.maxs[axis]);
        above.mins[axis] = at.max(space.mins[axis]);
        let middle = owners.start + half;
        let first = Self::new(first, owners.start..middle, below);
        let second = Self::new(second, middle..owners.end, above);
        Self::Cut(axis, at, Box::new([first, second]))
    }

    /// Tells of each process whose region a box reaches, and the region: for a point its owner only; for a box, whose sides are compared
    /// like points, the owner of each of its points.
    pub(crate) fn reach(&self, aabb: &Aabb<f64, D>, tell: &mut impl FnMut(usize, &Aabb<f64, D>)) {
        match self {
            Self::Leaf(process, region) => tell(*process, region),
            Self::Cut(axis, at, sides) => {
                if aabb.mins[*axis] < *at {
                    sides[0].reach(aabb, tell);
                }
                if aabb.maxs[*axis] >= *at {
                    sides[1].reach(aabb, tell);
                }
            }
        }
    }
}

/// The axis along which the points are spread the most.
fn widest_axis<const D: usize>(points: &[[f64; D]]) -> usize {
    let spread = |axis: usize| {
        let along = points.iter().map(|point| point[axis]);
        along.clone().fold(f64::MIN, f64::max) - along.fold(f64::MAX, f64::min)
    };
    let wider = |&a: &usize, &b: &usize| spread(a).total_cmp(&spread(b));
    (0..D).max_by(wider).unwrap_or(0)
}

/// The coordinate below which the number of points is nearest to `target`, and that number. These points are first in the list then.
fn cut<const D: usize>(points: &mut [[f64; D]], axis: usize, target: usize) -> (f64, usize) {
    points.sort_unstable_by(|a, b| a[axis].total_cmp(&b[axis]));
    let Some(&here) = points.get(target) else {
        return (0.0, 0);
    };
    // Of points with one coordinate, all go to the second side, or all to the first.
    let below = points.partition_point(|point| point[axis] < here[axis]);
    let through = points.partition_point(|point| point[axis] <= here[axis]);
    match points.get(through) {
        Some(next) if through - target < target - below => (next[axis], through),
        _ => (here[axis], below),
    }
}
