//! Recursive coordinate bisection (Berger and Bokhari, 1987): space is cut in two again and again, until each process has a region.

use std::ops::Range;
use unisize::Aabb;

/// A tree of cuts. The regions of its leaves partition space, points at infinity included.
pub(crate) enum Bisection<const D: usize> {
    /// A process, and its region. Finite `maxs` do not belong to the region.
    Leaf(usize, Aabb<f64, D>),
    /// An axis, and a finite coordinate on it. Points below are on the first side, all others on the second.
    Cut(usize, f64, Box<[Self; 2]>),
}

impl<const D: usize> Bisection<D> {
    /// Cuts `space` into a region for each of the processes `owners`, with about as many of the points in each. The points are finite. Equal
    /// points in equal order give equal regions; points that coincide stay together. **O(points · log points · log processes)**.
    pub(crate) fn new(points: &mut [[f64; D]], owners: Range<usize>, space: Aabb<f64, D>) -> Self {
        if owners.len() <= 1 {
            return Self::Leaf(owners.start, space);
        }
        let half = owners.len() / 2;
        let axis = widest_axis(points);
        let (at, below) = cut(points, axis, points.len() * half / owners.len());
        let (first, second) = points.split_at_mut(below);
        let [mut below, mut above] = [space; 2];
        // A cut without points may lie outside of the space.
        below.maxs[axis] = at.min(space.maxs[axis]);
        above.mins[axis] = at.max(space.mins[axis]);
        let middle = owners.start + half;
        let first = Self::new(first, owners.start..middle, below);
        let second = Self::new(second, middle..owners.end, above);
        Self::Cut(axis, at, Box::new([first, second]))
    }

    /// Visits the processes whose region a box reaches, and their regions. A point reaches one region; a box reaches the regions of all of its
    /// points, its sides included.
    pub(crate) fn reach(&self, aabb: &Aabb<f64, D>, visit: &mut impl FnMut(usize, &Aabb<f64, D>)) {
        match self {
            Self::Leaf(process, region) => visit(*process, region),
            Self::Cut(axis, at, sides) => {
                if aabb.mins[*axis] < *at {
                    sides[0].reach(aabb, visit);
                }
                if aabb.maxs[*axis] >= *at {
                    sides[1].reach(aabb, visit);
                }
            }
        }
    }
}

/// The axis along which the points spread the farthest.
fn widest_axis<const D: usize>(points: &[[f64; D]]) -> usize {
    let spread = |axis: usize| {
        let along = points.iter().map(|point| point[axis]);
        along.clone().fold(f64::MIN, f64::max) - along.fold(f64::MAX, f64::min)
    };
    let wider = |&a: &usize, &b: &usize| spread(a).total_cmp(&spread(b));
    (0..D).max_by(wider).unwrap_or(0)
}

/// The coordinate below which the number of points is nearest to `target`, and that number. Sorts these points to the front.
fn cut<const D: usize>(points: &mut [[f64; D]], axis: usize, target: usize) -> (f64, usize) {
    points.sort_unstable_by(|a, b| a[axis].total_cmp(&b[axis]));
    let Some(&here) = points.get(target) else {
        return (0.0, 0);
    };
    // Points with the same coordinate go to the same side.
    let below = points.partition_point(|point| point[axis] < here[axis]);
    let through = points.partition_point(|point| point[axis] <= here[axis]);
    match points.get(through) {
        Some(next) if through - target < target - below => (next[axis], through),
        _ => (here[axis], below),
    }
}
