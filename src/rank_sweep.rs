//! The kernel of the paper: a sweep over the second axis, with the active boxes ordered by their ranks on the first.
//!
//! The endpoints of both axes are sorted. On the first axis only their ranks matter (`ranks`). The sweep goes through the endpoints of
//! the second axis. At a low endpoint, the two ranks of the object enter the active set (`succ_tree`), and every rank between them
//! belongs to an object that overlaps on both axes. At a high endpoint, they leave.

mod ranks;
mod succ_tree;
#[cfg(test)]
mod tests;

use std::time::Duration;

use crate::aabb::Aabb;
use crate::clock;
use crate::invalid_input::InvalidInput;
use crate::pair_finder::{PairFinder, check_boxes, check_count, ordered};
use crate::parallel;
use crate::radix_sort::RadixSort;
use crate::real::Real;
use crate::tuning::kernel::SORT_BOTH_AXES_FROM;
use crate::tuning::prices::SEARCHED;
use succ_tree::SuccTree;

/// Two endpoints per box, numbered by `u32`, with one number to spare.
const MAX_BOXES: usize = (u32::MAX / 2) as usize;

/// The sweep fetches the ranks of this many endpoints at once. They are scattered in memory, and a batch takes hardly longer than one.
/// Fetched one by one, they make the whole sweep a tenth slower.
const BATCH: usize = 32;

/// Sweep and prune by ranks: Algorithm 1 of Capannini and Larsson, *Output sensitive collision detection for unisize boxes* (2016).
///
/// Computes in **O(n log₆₄ n + c)** time and **O(n)** memory besides the pairs, where c is the number of *candidates*: the pairs that
/// overlap on the second axis, and also on the first axis after each box has been widened to end no earlier than any that begins before it.
///
/// - Boxes of one size are not widened. In 2D, the candidates are the answer without a test, so the time is optimal for the size of the
///   output, wherever the boxes are. Boxes count as of one size if they end, on the first axis, in the order in which they begin. They do
///   if `maxs` is `mins` plus one size, for any rounding of the sum.
/// - The more the sizes differ, the more candidates fail.
/// - **One huge box widens every box that begins after it on the first axis.** Every pair of these boxes that overlaps on the second axis
///   becomes a candidate. The pairs are still right; only the time suffers.
/// - In 3D and beyond, the further axes only test the candidates, as in section 7 of the paper. If there are many boxes across all axes,
///   most candidates fail.
///
/// The axes are used in the given order, so boxes should be spread along the first two. `D` must not be 0.
///
/// Takes at most 2³¹ - 1 boxes, because each has two endpoints, and refuses more as [`TooMany`](crate::InvalidInputReason::TooMany).
///
/// With the feature `parallel`, two threads sort the endpoints of the two axes at the same time, as in section 7 of the paper. The sweep
/// takes one thread. The pairs are the same, in the same order.
///
/// ```
/// use unisize::{Aabb, PairFinder, RankSweep};
///
/// let square = |x: f32, y: f32| Aabb::new([x, y], [x + 1.0, y + 1.0]);
/// let boxes = [square(0.0, 0.0), square(0.5, 0.5), square(3.0, 0.0)];
/// let mut finder = RankSweep::default();
/// let mut pairs = Vec::new();
/// finder.find_pairs(&boxes, &mut pairs)?;
/// assert_eq!(pairs, [[0, 1]]);
/// let [sorting, pairing] = finder.phase_times();
/// println!("sorting took {sorting:?}, pairing {pairing:?}");
/// # Ok::<(), unisize::InvalidInput>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct RankSweep<R: Real, const D: usize> {
    /// Scratch, as are the other fields: the first two axes. If they are sorted one after the other, both use the first of these.
    axes: [Endpoints<R>; 2],
    /// The objects in the order of their low endpoints on the first axis.
    lows: Vec<u32>,
    /// By object, the ranks of its low and its high endpoint on the first axis.
    ranks: Vec<[u32; 2]>,
    /// The ranks of the active objects; each has its object as a label.
    active: SuccTree,
    phase_times: [Duration; 2],
}

/// The `2n` endpoints of an axis: the low one of object `i` at `i`, and the high one at `i + n`.
#[derive(Clone, Debug, Default)]
struct Endpoints<R: Real> {
    /// Integers in the order of the coordinates.
    keys: Vec<R::Key>,
    /// The endpoints in order.
    order: Vec<u32>,
    sorter: RadixSort<R::Key>,
}

impl<R: Real> Endpoints<R> {
    /// Sorts the endpoints of an axis, in **O(n)** time. The sort is stable. So low endpoints precede equal high ones, as closed boxes
    /// require, and equal endpoints of a kind are in the order of their objects.
    fn sort<const D: usize>(&mut self, boxes: &[Aabb<R, D>], axis: usize) {
        let (lows, highs) = (boxes.iter(), boxes.iter());
        self.keys.clear();
        self.keys.extend(lows.map(|b| b.mins[axis].order_key()));
        self.keys.extend(highs.map(|b| b.maxs[axis].order_key()));
        self.sorter.sort(&self.keys, &mut self.order);
    }
}

impl<R: Real, const D: usize> PairFinder<R, D> for RankSweep<R, D> {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        const { assert!(D > 0, "boxes need an axis") };
        pairs.clear();
        check_count(boxes.len(), MAX_BOXES)?;
        check_boxes(boxes)?;
        let began = clock::now();
        let work = match D > 1 && boxes.len() >= SORT_BOTH_AXES_FROM {
            true => SEARCHED * boxes.len() as u64,
            false => 0,
        };
        let ([first, second], lows, ranks) = (&mut self.axes, &mut self.lows, &mut self.ranks);
        let (is_exact, swept) = parallel::enter(work, || {
            let mut rank_first = || {
                first.sort(boxes, 0);
                ranks::rank_endpoints(&first.keys, &first.order, lows, ranks)
            };
            if work > 0 && parallel::threads() > 1 {
                let (is_exact, ()) = parallel::join(rank_first, || second.sort(boxes, 1));
                return (is_exact, 1);
            }
            let is_exact = rank_first();
            // This reuses the memory of the first axis. In 1D, the sweep goes over the first axis too.
            if D > 1 {
                first.sort(boxes, 1);
            }
            (is_exact, 0)
        });
        let (sorting, began) = (clock::since(began), clock::now());
        if is_exact {
            // The sweep decides two axes. One interval remains in 3D; in 2D, the boxes need not even be read.
            self.sweep(swept, pairs, |p, q| {
                (2..D).all(|k| {
                    let (a, b) = (&boxes[p as usize], &boxes[q as usize]);
                    (a.mins[k] <= b.maxs[k]) & (b.mins[k] <= a.maxs[k])
                })
            });
        } else {
            let overlap = |p, q| boxes[p as usize].intersects(&boxes[q as usize]);
            self.sweep(swept, pairs, overlap);
        }
        self.phase_times = [sorting, clock::since(began)];
        Ok(())
    }
}

impl<R: Real, const D: usize> RankSweep<R, D> {
    /// Returns how long the last search took to sort and rank the endpoints, and to sweep them, which the paper calls the pairing phase.
    /// Zeros if there is no clock, as on `wasm32-unknown-unknown`.
    pub fn phase_times(&self) -> [Duration; 2] {
        self.phase_times
    }

    /// Sweeps the endpoints of the second axis, which are sorted in `axes[swept]`. Appends the pairs of objects that overlap on both axes
    /// and pass the test.
    // Not inlined, so that profilers show it apart from the sorting.
    #[inline(never)]
    fn sweep(
        &mut self,
        swept: usize,
        pairs: &mut Vec<[u32; 2]>,
        overlap: impl Fn(u32, u32) -> bool,
    ) {
        let (ranks, active) = (&self.ranks, &mut self.active);
        let n = ranks.len() as u32;
        active.reset(2 * n);
        let mut batch = [[0; 2]; BATCH];
        for endpoints in self.axes[swept].order.chunks(BATCH) {
            for (ranks_of, &endpoint) in batch.iter_mut().zip(endpoints) {
                let p = if endpoint < n { endpoint } else { endpoint - n };
                *ranks_of = ranks[p as usize];
            }
            for (&p, &[low, high]) in endpoints.iter().zip(&batch) {
                if p >= n {
                    active.remove(low);
                    active.remove(high);
                    continue;
                }
                let mut rank = active.insert(low, p);
                while rank < high {
                    let q = active.label(rank);
                    if overlap(p, q) {
                        pairs.push(ordered(p, q));
                    }
                    rank = active.next(rank);
                }
                active.insert_before(rank, high, p);
            }
        }
    }
}
