//! A sweep over the second axis that asks for ranges of the first, for boxes of any sizes.
//!
//! An interval that overlaps another one either begins inside it or contains its beginning. With the ranks of low
//! endpoints in order, one range query gives the former. The latter can only be found if the lengths of intervals are
//! known. So intervals are divided into classes by length (`length_class`); in each class only intervals that overlap
//! are looked at.

mod length_class;
#[cfg(test)]
mod tests;

use crate::endpoints::{self, Endpoint};
use crate::{check_boxes, ordered};
use length_class::{CLASSES, LengthClass, class_of};
use unisize::{Aabb, InvalidInput, PairFinder, Real};

/// The ranks of this many endpoints are fetched before these endpoints are swept, because they are scattered in memory.
const BATCH: usize = 32;

/// A sweep on two axes for boxes of any sizes, after Capannini and Larsson, *Efficient collision culling by a succinct
/// bi-dimensional sweep and prune algorithm* (2016).
///
/// Theirs, as far as the later paper describes it: the endpoints of the first axis are replaced by their ranks; the
/// second axis is swept; the ranks of the active boxes are kept in a SuccTree, a tree with one bit per node and 64
/// children each; and range queries on it replace testing all active boxes. An interval that contains another one
/// completely is not seen by a query for endpoints inside the latter; the later paper does not tell how it is found.
///
/// Ours: intervals are divided into classes by their length in ranks, so that in no class the longest is twice as long
/// as the shortest. Each class has two trees, one of low and one of high endpoints. In a class with lengths from `s` to
/// `l`, the intervals that reach a rank `x` begin less than `s` before it, or end within the next `l - s`. So two range
/// queries give all that overlap on the first axis, and nothing else.
///
/// Computes in **O((n log n + c) log₆₄ n)** time, where c is the number of pairs that overlap on the first two axes, and
/// **O(n)** memory beside the pairs: the trees of all classes together have a little more than 4 n log₂ n bits. In 2D, c
/// is the size of the answer, so the time is quadratic only if the number of pairs is, for boxes of any sizes; and boxes
/// of one size fall into one or a few classes. In 3D and beyond, the further axes only test the candidates.
///
/// The axes are taken in the given order: let the first two be those along which boxes are spread out. `D` must not be
/// 0.
#[derive(Clone, Debug, Default)]
pub struct DualAxisSweep<R, const D: usize> {
    /// Scratch memory: the endpoints of one axis in order.
    endpoints: Vec<Endpoint<R>>,
    sweep: Sweep,
}

/// What the sweep works on. All of it is scratch memory.
#[derive(Clone, Debug, Default)]
struct Sweep {
    /// The endpoints in the order of the first axis.
    first: Vec<u32>,
    /// The endpoints in the order of the axis that is swept.
    swept: Vec<u32>,
    /// By object, the ranks of its low and of its high endpoint on the first axis, counted from one.
    ranks: Vec<[u32; 2]>,
    /// The active boxes, by the lengths of their intervals on the first axis.
    classes: [LengthClass; CLASSES],
}

impl<R: Real, const D: usize> PairFinder<R, D> for DualAxisSweep<R, D> {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        const { assert!(D > 0, "boxes need an axis") };
        pairs.clear();
        check_boxes(boxes)?;
        let Self { endpoints, sweep } = self;
        // With one axis only, that is swept as well.
        let orders = [(0, &mut sweep.first), (1.min(D - 1), &mut sweep.swept)];
        for (axis, order) in orders {
            endpoints::sort(boxes, axis, endpoints);
            order.clear();
            order.extend(endpoints.iter().map(|&(_, endpoint)| endpoint));
        }
        sweep.rank(boxes.len());
        if D <= 2 {
            sweep.sweep(pairs, |_, _| true);
        } else {
            sweep.sweep(pairs, |p, q| boxes[p as usize].overlaps(&boxes[q as usize]));
        }
        Ok(())
    }
}

impl Sweep {
    /// Ranks the endpoints of the first axis, and sets up the classes for the lengths between them.
    fn rank(&mut self, n: usize) {
        self.ranks.resize(n, [0; 2]);
        for (rank, &endpoint) in (1..).zip(&self.first) {
            let endpoint = endpoint as usize;
            if endpoint < n {
                self.ranks[endpoint][0] = rank;
            } else {
                self.ranks[endpoint - n][1] = rank;
            }
        }
        self.classes.iter_mut().for_each(LengthClass::clear);
        for &[low, high] in &self.ranks {
            self.classes[class_of(high - low)].admit(high - low);
        }
        for class in &mut self.classes {
            class.reset(self.first.len() as u32);
        }
    }

    /// Sweeps the second axis and appends the pairs of objects that overlap on both axes and pass the test.
    #[inline]
    fn sweep(&mut self, pairs: &mut Vec<[u32; 2]>, overlap: impl Fn(u32, u32) -> bool) {
        let Self {
            first,
            swept,
            ranks,
            classes,
        } = self;
        let n = ranks.len() as u32;
        // One bit per class: whether it has any active interval.
        let mut active = 0_u32;
        let mut batch = [[0; 2]; BATCH];
        for endpoints in swept.chunks(BATCH) {
            for (ranks_of, &endpoint) in batch.iter_mut().zip(endpoints) {
                let p = if endpoint < n { endpoint } else { endpoint - n };
                *ranks_of = ranks[p as usize];
            }
            for (&p, &interval) in endpoints.iter().zip(&batch) {
                let own = class_of(interval[1] - interval[0]);
                if p >= n {
                    if classes[own].remove(interval) {
                        active &= !(1 << own);
                    }
                    continue;
                }
                let mut report = |q: u32| {
                    if overlap(p, q) {
                        pairs.push(ordered(p, q));
                    }
                };
                let mut others = active;
                while others != 0 {
                    let class = &classes[others.trailing_zeros() as usize];
                    class.beginning(interval, |rank| report(first[rank as usize - 1]));
                    class.ending(interval[0], |rank| {
                        let q = first[rank as usize - 1] - n;
                        if ranks[q as usize][0] <= class.earliest(interval[0]) {
                            report(q);
                        }
                    });
                    others &= others - 1;
                }
                if classes[own].insert(interval) {
                    active |= 1 << own;
                }
            }
        }
    }
}
