//! The paper's kernel: a sweep over the second axis, with the active boxes ordered by their ranks on the first.
//!
//! The endpoints of both axes are sorted (`crate::endpoints`). The first axis is used for the places that its endpoints get
//! (`ranks`). The second is swept: at a low endpoint the object's two ranks enter the active set (`succ_tree`), and every
//! rank that lies between them there belongs to an object that overlaps on both axes; at a high endpoint they leave.

mod ranks;
mod succ_tree;
#[cfg(test)]
mod tests;

use core::marker::PhantomData;

use crate::endpoints::{Endpoints, SortKey, check_count};
use crate::pair_finder::{check_boxes, ordered};
use crate::parallel;
use crate::stopwatch::Stopwatch;
use crate::tuning::kernel::SORT_BOTH_AXES_FROM;
use crate::{Aabb, InvalidBox, PairFinder, PhaseTimes, Real};
use succ_tree::SuccTree;

/// The ranks of so many endpoints are fetched before these are swept. They lie all over the place, and fetching them at
/// once takes little longer than fetching one; taken one by one, the sweep takes a tenth more time in all.
const BATCH: usize = 32;

/// Sweep and prune by ranks: Algorithm 1 of Capannini and Larsson, *Output sensitive collision detection for unisize
/// boxes* (2016).
///
/// Computes in **O(n log₆₄ n + c)** time and **O(n)** memory beside the pairs, where c is the number of *candidates*: pairs
/// that overlap on the second axis as they are, and on the first once each box has been widened to reach as far as any that
/// begins before it.
///
/// - For boxes of one size, nothing is widened: in 2D, candidates are the answer itself and are not even tested, so the
///   time is worst-case optimal in the size of the output, wherever the boxes are. Boxes count as of one size as long as
///   they end, on the first axis, in the order in which they begin, which they do when `maxs` is `mins` plus one size,
///   however that was rounded.
/// - For boxes of about one size, as many candidates fail as sizes differ.
/// - **One huge box makes every box after it on the first axis reach as far**, and every pair of boxes that overlap on the
///   second axis a candidate. Nothing is wrong then but the time.
/// - In 3D and beyond, the further axes only test the candidates, as section 7 of the paper has it. Where boxes are many
///   across all axes, most candidates fail.
///
/// The axes are taken as they come: let the first two be those along which boxes are spread out.
/// `D` must not be 0.
///
/// Boxes are limited to 2³¹ - 1, for each has two endpoints; one more is refused as
/// [`TooMany`](crate::InvalidBoxReason::TooMany).
///
/// With the feature `parallel`, the endpoints of the two axes are sorted at once, as section 7 of the paper has it; the
/// sweep goes on alone. The pairs are the same, in the same order.
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
/// # Ok::<(), unisize::InvalidBox>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct RankSweep<R, const D: usize> {
    /// Scratch memory for keys of 32 bits, empty unless `R` is `f32`.
    narrow: [Endpoints<u32>; 2],
    /// Scratch memory for keys of 64 bits, empty unless `R` is `f64`.
    wide: [Endpoints<u64>; 2],
    sweep: Sweep,
    stopwatch: Stopwatch,
    real: PhantomData<R>,
}

/// What the sweep works on. All of it scratch memory.
#[derive(Clone, Debug, Default)]
struct Sweep {
    /// The endpoints of each axis in order; or of both, one after the other, in the first.
    orders: [Vec<u32>; 2],
    /// The objects in the order of their low endpoints on the first axis.
    lows: Vec<u32>,
    /// By object, the ranks of its low and of its high endpoint on the first axis.
    ranks: Vec<[u32; 2]>,
    /// The ranks of the objects that the sweep is in the midst of, labelled with the objects.
    active: SuccTree,
}

impl<R: Real, const D: usize> PairFinder<R, D> for RankSweep<R, D> {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidBox> {
        const { assert!(D > 0, "boxes need an axis") };
        pairs.clear();
        check_count(boxes.len())?;
        self.stopwatch.times = PhaseTimes::default();
        let lap = self.stopwatch.start();
        check_boxes(boxes)?;
        self.stopwatch.lap(lap, |times| &mut times.read);
        let Self {
            narrow,
            wide,
            sweep,
            stopwatch,
            ..
        } = self;
        if size_of::<R>() == size_of::<u32>() {
            sweep.find_pairs(narrow, boxes, pairs, stopwatch);
        } else {
            sweep.find_pairs(wide, boxes, pairs, stopwatch);
        }
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
}

impl Sweep {
    fn find_pairs<R: Real, K: SortKey, const D: usize>(
        &mut self,
        [first, second]: &mut [Endpoints<K>; 2],
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) {
        let lap = stopwatch.start();
        let Self {
            orders: [order, second_order],
            lows,
            ranks,
            ..
        } = self;
        let sort_both = D > 1 && boxes.len() >= SORT_BOTH_AXES_FROM && parallel::threads() > 1;
        let mut rank_first = || {
            first.sort(boxes, 0, order);
            ranks::rank_endpoints(&first.keys, order, lows, ranks)
        };
        let exact = if sort_both {
            let (exact, ()) = parallel::join(rank_first, || second.sort(boxes, 1, second_order));
            exact
        } else {
            let exact = rank_first();
            // In the memory of the first axis. With one axis only, that is swept as well.
            if D > 1 {
                first.sort(boxes, 1, order);
            }
            exact
        };
        let swept = usize::from(sort_both);
        let lap = stopwatch.lap(lap, |times| &mut times.sort);
        if exact && D <= 2 {
            self.sweep(swept, pairs, |_, _| true);
        } else {
            let overlap = |p, q| boxes[p as usize].overlaps(&boxes[q as usize]);
            self.sweep(swept, pairs, overlap);
        }
        stopwatch.lap(lap, |times| &mut times.sweep);
    }

    /// Sweeps the endpoints of the second axis, whose order is the first or the second one, and appends the pairs of objects
    /// that overlap on both axes and pass the test.
    // Not inlined, so that a profiler can tell it from the sorting.
    #[inline(never)]
    fn sweep(
        &mut self,
        swept: usize,
        pairs: &mut Vec<[u32; 2]>,
        overlap: impl Fn(u32, u32) -> bool,
    ) {
        let Self {
            orders,
            ranks,
            active,
            ..
        } = self;
        let n = ranks.len() as u32;
        active.reset(2 * n);
        let mut batch = [[0; 2]; BATCH];
        for endpoints in orders[swept].chunks(BATCH) {
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
