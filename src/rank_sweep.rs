//! The paper's kernel: a sweep over the second axis, with the active boxes ordered by their ranks on the first.
//!
//! The endpoints of both axes are sorted. On the first axis only their ranks matter (`ranks`). The second axis is swept:
//! at a low endpoint the object's two ranks enter the active set (`succ_tree`), and every rank between them there belongs
//! to an object that overlaps on both axes; at a high endpoint they leave.

mod ranks;
mod succ_tree;
#[cfg(test)]
mod tests;

use crate::aabb::Aabb;
use crate::invalid_input::InvalidInput;
use crate::pair_finder::{PairFinder, check_boxes, check_count, ordered};
use crate::parallel;
use crate::radix_sort::RadixSort;
use crate::real::Real;
use crate::stopwatch::{Phase, PhaseTimes, Stopwatch};
use crate::tuning::kernel::SORT_BOTH_AXES_FROM;
use succ_tree::SuccTree;

/// Two endpoints per box, numbered by `u32`, with one number to spare.
const MAX_BOXES: usize = (u32::MAX / 2) as usize;

/// The ranks of this many endpoints are fetched before these endpoints are swept. They are scattered in memory, and
/// fetching a batch takes little longer than fetching one. Fetched one by one, they make the whole sweep a tenth slower.
const BATCH: usize = 32;

/// Sweep and prune by ranks: Algorithm 1 of Capannini and Larsson, *Output sensitive collision detection for unisize
/// boxes* (2016).
///
/// Computes in **O(n log₆₄ n + c)** time and **O(n)** memory beside the pairs, where c is the number of *candidates*:
/// pairs that overlap on the second axis, and on the first axis once each box has been widened to end no earlier than
/// any that begins before it.
///
/// - For boxes of one size, nothing is widened: in 2D, the candidates are the answer and are not even tested, so the
///   time is worst-case optimal in the size of the output, wherever the boxes are. Boxes count as being of one size as
///   long as they end, on the first axis, in the order in which they begin. They do when `maxs` is `mins` plus one size,
///   however the sum is rounded.
/// - For boxes of about one size, the more the sizes differ, the more candidates fail.
/// - **One huge box widens every box that begins after it on the first axis**, and makes every pair of boxes that
///   overlap on the second axis a candidate. The pairs are still right; only the time suffers.
/// - In 3D and beyond, the further axes only test the candidates, as section 7 of the paper has it: one more interval an
///   axis. Where there are many boxes across all axes, most candidates fail.
///
/// The axes are taken in the given order: let the first two be those along which boxes are spread out. `D` must not be
/// 0.
///
/// At most 2³¹ - 1 boxes, because each has two endpoints; more are refused as
/// [`TooMany`](crate::InvalidInputReason::TooMany).
///
/// With the feature `parallel`, the endpoints of the two axes are sorted at the same time, as section 7 of the paper has
/// it; the sweep takes one thread. The pairs are the same, in the same order.
///
/// ```
/// use unisize::{Aabb, PairFinder, RankSweep};
///
/// let square = |x: f32, y: f32| Aabb::new([x, y], [x + 1.0, y + 1.0]);
/// let boxes = [square(0.0, 0.0), square(0.5, 0.5), square(3.0, 0.0)];
/// let mut finder = RankSweep::default().timed();
/// let mut pairs = Vec::new();
/// finder.find_pairs(&boxes, &mut pairs)?;
/// assert_eq!(pairs, [[0, 1]]);
/// let times = finder.phase_times();
/// println!("sorting took {:?}, pairing {:?}", times.sort, times.sweep);
/// # Ok::<(), unisize::InvalidInput>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct RankSweep<R: Real, const D: usize> {
    /// The first two axes. If they are sorted one after the other, both use the first of these. All is scratch memory, as
    /// is the rest.
    axes: [Endpoints<R>; 2],
    /// The objects in the order of their low endpoints on the first axis.
    lows: Vec<u32>,
    /// By object, the ranks of its low and of its high endpoint on the first axis.
    ranks: Vec<[u32; 2]>,
    /// The ranks of the active objects, labelled with the objects.
    active: SuccTree,
    stopwatch: Stopwatch,
}

/// The `2n` endpoints of an axis: the low one of object `i` at `i`, the high one at `i + n`.
#[derive(Clone, Debug, Default)]
struct Endpoints<R: Real> {
    /// Integers that compare as the coordinates do.
    keys: Vec<R::Key>,
    /// The endpoints in order.
    order: Vec<u32>,
    sorter: RadixSort<R::Key>,
}

impl<R: Real> Endpoints<R> {
    /// Sorts the endpoints of an axis, in **O(n)** time. The sort is stable, so low endpoints come before equal high ones, as
    /// closed boxes require, and each kind is in the order of objects.
    fn sort<const D: usize>(&mut self, boxes: &[Aabb<R, D>], axis: usize) {
        let (lows, highs) = (boxes.iter(), boxes.iter());
        self.keys.clear();
        self.keys.extend(lows.map(|b| b.mins[axis].order_key()));
        self.keys.extend(highs.map(|b| b.maxs[axis].order_key()));
        let indexed = self.keys.iter().enumerate();
        let indexed = indexed.map(|(i, &key)| (key, i as u32));
        self.sorter
            .sort(indexed, |(_, index)| index, &mut self.order);
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
        self.stopwatch = self.stopwatch.reset();
        self.stopwatch.enter(Phase::Read);
        check_boxes(boxes).inspect_err(|_| self.stopwatch.leave())?;
        self.stopwatch.enter(Phase::Sort);
        let sort_both = D > 1 && boxes.len() >= SORT_BOTH_AXES_FROM && parallel::threads() > 1;
        let ([first, second], lows, ranks) = (&mut self.axes, &mut self.lows, &mut self.ranks);
        let mut rank_first = || {
            first.sort(boxes, 0);
            ranks::rank_endpoints(&first.keys, &first.order, lows, ranks)
        };
        let (is_exact, swept) = if sort_both {
            let (is_exact, ()) = parallel::join(rank_first, || second.sort(boxes, 1));
            (is_exact, 1)
        } else {
            let is_exact = rank_first();
            // Reuses the memory of the first axis. If there is only one axis, it is swept as well.
            if D > 1 {
                first.sort(boxes, 1);
            }
            (is_exact, 0)
        };
        self.stopwatch.enter(Phase::Sweep);
        if is_exact {
            // Two axes are decided: what is left is one more interval in 3D, and nothing in 2D, not even a look at the boxes.
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
        self.stopwatch.leave();
        Ok(())
    }
}

impl<R: Real, const D: usize> RankSweep<R, D> {
    /// The same kernel, which from now on takes the [times of its phases](Self::phase_times).
    pub fn timed(self) -> Self {
        Self {
            stopwatch: Stopwatch::new(true),
            ..self
        }
    }

    /// How long each phase of the last run has taken; zeros unless it was [`timed`](Self::timed). The ranks are a part of
    /// [`sort`](PhaseTimes::sort); [`sweep`](PhaseTimes::sweep) is what the paper calls the pairing phase.
    pub fn phase_times(&self) -> PhaseTimes {
        self.stopwatch.times
    }

    /// Sweeps the endpoints of the second axis, which are sorted in `axes[swept]`, and appends the pairs of objects that
    /// overlap on both axes and pass the test.
    // Not inlined, so that a profiler can tell it from the sorting.
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
