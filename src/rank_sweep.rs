//! The paper's kernel: a sweep over the second axis, with the active boxes ordered by their ranks on the first.
//!
//! An axis has `2n` endpoints, the low one of object `i` at `i`, the high one at `i + n`; sorting them is one stable radix
//! sort of integers (`radix_sort`), which lets low endpoints come before equal high ones, as closed boxes want it, and both
//! kinds in the order of object ids. The first axis is used for the places that its endpoints get (`ranks`). The second is
//! swept: at a low endpoint the object's two ranks enter the active set (`succ_tree`), and every rank that lies between them
//! there belongs to an object that overlaps on both axes; at a high endpoint they leave.

mod radix_sort;
mod ranks;
mod succ_tree;
#[cfg(test)]
mod tests;

use core::marker::PhantomData;

use crate::pair_finder::{check_boxes, ordered};
use crate::parallel;
use crate::stopwatch::Stopwatch;
use crate::{Aabb, InvalidBox, InvalidBoxReason, PairFinder, PhaseTimes, Real};
use radix_sort::{RadixSort, SortKey};
use succ_tree::SuccTree;

/// Two endpoints a box, numbered by `u32`, with one number to spare.
const MAX_BOXES: usize = (u32::MAX / 2) as usize;

/// With fewer boxes, a second thread for the second axis is not worth it.
const WORTH_A_THREAD: usize = 1 << 14;

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
/// [`InvalidBoxReason::TooMany`].
///
/// With the feature `parallel`, the endpoints of the two axes are sorted at once, as section 7 of the paper has it; the
/// sweep goes on alone. The pairs are the same, in the same order.
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

/// The endpoints of one axis, or of one axis after the other. All of it scratch memory.
#[derive(Clone, Debug, Default)]
struct Endpoints<K> {
    /// Integers that are ordered as the endpoints are: lows at `i`, highs at `i + n`.
    keys: Vec<K>,
    sorter: RadixSort<K>,
    /// The endpoints in order.
    order: Vec<u32>,
}

/// What the sweep works on. All of it scratch memory.
#[derive(Clone, Debug, Default)]
struct Sweep {
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

fn check_count(count: usize) -> Result<(), InvalidBox> {
    if count > MAX_BOXES {
        return Err(InvalidBox {
            index: MAX_BOXES,
            reason: InvalidBoxReason::TooMany,
        });
    }
    Ok(())
}

impl<K: SortKey> Endpoints<K> {
    /// Sorts the endpoints of an axis.
    fn sort<R: Real, const D: usize>(&mut self, boxes: &[Aabb<R, D>], axis: usize) {
        let key = |x: R| K::from_order_key(x.order_key());
        self.keys.clear();
        self.keys.extend(boxes.iter().map(|b| key(b.mins[axis])));
        self.keys.extend(boxes.iter().map(|b| key(b.maxs[axis])));
        self.sorter.sort(&self.keys, &mut self.order);
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
        let Self { lows, ranks, .. } = self;
        let mut rank = |endpoints: &mut Endpoints<K>| {
            endpoints.sort(boxes, 0);
            ranks::rank_endpoints(&endpoints.keys, &endpoints.order, lows, ranks)
        };
        let (exact, order) = if D > 1 && boxes.len() >= WORTH_A_THREAD && parallel::threads() > 1 {
            let (exact, ()) = parallel::join(|| rank(first), || second.sort(boxes, 1));
            (exact, &second.order)
        } else {
            let exact = rank(first);
            // In the memory of the first axis. With one axis only, that is swept as well.
            if D > 1 {
                first.sort(boxes, 1);
            }
            (exact, &first.order)
        };
        let lap = stopwatch.lap(lap, |times| &mut times.sort);
        if exact && D <= 2 {
            self.sweep(order, pairs, |_, _| true);
        } else {
            let overlap = |p, q| boxes[p as usize].overlaps(&boxes[q as usize]);
            self.sweep(order, pairs, overlap);
        }
        stopwatch.lap(lap, |times| &mut times.sweep);
    }

    /// Sweeps the endpoints of the second axis, in order, and appends the pairs of objects that overlap on both axes and
    /// pass the test.
    // Not inlined, so that a profiler can tell it from the sorting.
    #[inline(never)]
    fn sweep(
        &mut self,
        order: &[u32],
        pairs: &mut Vec<[u32; 2]>,
        overlap: impl Fn(u32, u32) -> bool,
    ) {
        let Self { ranks, active, .. } = self;
        let n = ranks.len() as u32;
        active.reset(2 * n);
        let mut batch = [[0; 2]; BATCH];
        for endpoints in order.chunks(BATCH) {
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
