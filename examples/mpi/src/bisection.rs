//! Space, cut in two again and again until each process has a region: recursive coordinate bisection (Berger and Bokhari, 1987).

use std::ops::Range;
use unisize::Aabb;

/// A tree of cuts. The regions of its leaves are half-open boxes that partition space, points at infinity included.
#[derive(Clone, Debug)]
pub enum Bisection {
    /// The region of this process.
    Leaf(usize),
    /// Points below `at` on `axis` are on the first side, all others on the second.
    Cut {
        /// The axis.
        axis: usize,
        /// A finite coordinate.
        at: f64,
        /// What is below, and the rest.
        sides: Box<[Self; 2]>,
    },
}

impl Bisection {
    /// Regions for these processes, each with about as many of the points, which are finite. Equal points in equal order give equal
    /// regions; points that coincide stay together. **O(points · log points · log processes)**.
    pub fn new<const D: usize>(points: &mut [[f64; D]], processes: Range<usize>) -> Self {
        if processes.len() <= 1 {
            return Self::Leaf(processes.start);
        }
        let half = processes.len() / 2;
        let axis = widest_axis(points);
        let (at, below) = cut(points, axis, points.len() * half / processes.len());
        let (first, second) = points.split_at_mut(below);
        let middle = processes.start + half;
        let first = Self::new(first, processes.start..middle);
        let second = Self::new(second, middle..processes.end);
        let sides = Box::new([first, second]);
        Self::Cut { axis, at, sides }
    }

    /// The process in whose region a point lies. **O(log processes)**.
    pub fn owner<const D: usize>(&self, point: &[f64; D]) -> usize {
        match self {
            Self::Leaf(process) => *process,
            Self::Cut { axis, at, sides } => sides[usize::from(point[*axis] >= *at)].owner(point),
        }
    }

    /// Appends each process whose region a box reaches. Its sides are compared as [`owner`](Self::owner) compares a point, so the owner of
    /// any point of the box is among them.
    pub fn reach<const D: usize>(&self, aabb: &Aabb<f64, D>, reached: &mut Vec<usize>) {
        match self {
            Self::Leaf(process) => reached.push(*process),
            Self::Cut { axis, at, sides } => {
                if aabb.mins[*axis] < *at {
                    sides[0].reach(aabb, reached);
                }
                if aabb.maxs[*axis] >= *at {
                    sides[1].reach(aabb, reached);
                }
            }
        }
    }

    /// Narrows `around` to the region of a process, and says whether it is below this cut. Finite `maxs` are not part of the region.
    pub fn narrow<const D: usize>(&self, process: usize, around: &mut Aabb<f64, D>) -> bool {
        match self {
            Self::Leaf(own) => *own == process,
            Self::Cut { axis, at, sides } => {
                let mut halves = [*around; 2];
                // A cut without points may lie outside.
                halves[0].maxs[*axis] = at.min(around.maxs[*axis]);
                halves[1].mins[*axis] = at.max(around.mins[*axis]);
                let found = (0..2).find(|&i| sides[i].narrow(process, &mut halves[i]));
                found.inspect(|&i| *around = halves[i]).is_some()
            }
        }
    }
}

/// The axis along which the points are spread the most; halves do not overflow.
fn widest_axis<const D: usize>(points: &[[f64; D]]) -> usize {
    let spread = |axis: usize| {
        let along = points.iter().map(|point| 0.5 * point[axis]);
        along.clone().fold(f64::MIN, f64::max) - along.fold(f64::MAX, f64::min)
    };
    let spreads: [f64; D] = std::array::from_fn(spread);
    let wider = |&a: &usize, &b: &usize| spreads[a].total_cmp(&spreads[b]);
    (0..D).max_by(wider).unwrap_or(0)
}

/// The coordinate below which the number of points is nearest to `target`, and that number. These points are first in the list then.
fn cut<const D: usize>(points: &mut [[f64; D]], axis: usize, target: usize) -> (f64, usize) {
    if points.is_empty() {
        return (0.0, 0);
    }
    points.sort_unstable_by(|a, b| a[axis].total_cmp(&b[axis]));
    let here = points[target][axis];
    // Of points with one coordinate, all go to the second side, or all to the first.
    let below = points.partition_point(|point| point[axis] < here);
    let through = points.partition_point(|point| point[axis] <= here);
    match points.get(through) {
        Some(next) if through - target < target - below => (next[axis], through),
        _ => (here, below),
    }
}
