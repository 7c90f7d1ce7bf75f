//! The fast kernel: sorted tubes, swept eight boxes at a time.
//!
//! # The bound
//!
//! Samples decide only the speed, and some order of the boxes misleads every one of them. Whatever they say, n boxes with k pairs take
//! **O(n logᴰ n + k log k)** time and **O(n + k)** memory, and where the tree takes over, O(n) more for each thread:
//!
//! 1. There are at most eight [classes](MOST_CLASSES), because the last one takes all valid boxes that are left. Each assigns them at most six
//!    times: for each [grid that it tries](crate::tuning::kernel::GRID_TRIES), for the best of them or a single tube, and without the boxes
//!    of crowded tubes.
//! 2. A box has at most four entries in the tubes of its class. A grid has at most twice as many tubes as boxes, or 64.
//! 3. The sweep of a tube has a budget for each entry and each pair, unless it has [few entries](crate::tuning::kernel::NO_CROWD_UP_TO).
//!    Where it exceeds the budget, the tree takes over.
//! 4. There are at most 28 pairs of classes. Between two, a sample of at most 64 boxes is looked up in each direction, which takes at most a
//!    sixteenth of what the tree would. Then each query stops soon after it has spent its budget, and some comparisons for each of its pairs. The tree takes
//!    those that do, and all if the sample says that they will, unless even visiting all tubes and boxes takes them a tenth of its time.
//! 5. A look-up without a budget visits each tube of the other class at most once, and compares each of its entries at most once.
//! 6. The tree takes the time above for boxes in any order. Its sample decides only the order of the axes.
//!
//! A pair meets in at most four tubes of each grid, so the budgets for pairs are bounded as well.
//!
//! The bound is that of a search. A later [look-up](GridSweep::look_up_queries) among its members has no budget. The tracker counts the
//! comparisons, and makes a full search once they cost more than full searches do.

mod assignment;
mod choose;
mod class;
mod entry;
mod grid;
mod lookup;
mod search;
mod segment_tree;
mod slab;
mod sweep;
#[cfg(test)]
mod tests;
mod worker;

use crate::aabb::Aabb;
use crate::invalid_input::InvalidInput;
use crate::pair_finder::{PairFinder, check_boxes, check_count};
use crate::parallel;
use crate::real::Real;
use crate::tuning::kernel::MOST_CLASSES;
use crate::tuning::prices::SEARCHED;
use assignment::Assignment;
use class::Class;
use search::Search;
use worker::Tally;

/// Entries are numbered with 32 bits, and a box may have four.
pub(crate) const MAX_BOXES: usize = 1 << 29;

/// Cuts space into tubes along the first axis, sorts each by `mins[0]` and sweeps it.
///
/// The second and the third axis are cut into strips a few boxes wide, and so space into tubes. In each tube, eight boxes at a time are
/// compared with those that follow them. Boxes that are much larger than most, or that crowd in a tube, form a class with a grid of its own.
/// For each two classes, the boxes of one are looked up in the other, or a segment tree finds the pairs where that costs too much.
///
/// Exact for boxes of any sizes and in any dimension: the tubes decide only the speed.
///
/// Computes in **O(n + pairs)** time if the boxes are of about one size, wherever they lie, and in **O((n + pairs) log n)** time for most
/// boxes of different sizes. No input takes more than **O(n logᴰ n + pairs log pairs)**, whatever the order of the boxes. The head of
/// `grid_sweep.rs` has the argument. Memory is always **O(n + pairs)** for any fixed number of threads.
///
/// Takes at most 2²⁹ boxes and refuses more as [`TooMany`](crate::InvalidInputReason::TooMany).
///
/// With the feature `parallel`, as many threads as the current Rayon pool has share the work on many boxes. The pairs are the same, in the
/// same order.
///
/// ```
/// use unisize::{Aabb, GridSweep, PairFinder};
///
/// let boxes = [
///     Aabb::new([0.0_f32, 0.0], [1.0, 1.0]),
///     Aabb::new([1.0, 0.5], [2.0, 1.5]), // Touches the first.
///     Aabb::new([5.0, 5.0], [6.0, 6.0]),
/// ];
/// let mut pairs = Vec::new();
/// GridSweep::default().find_pairs(&boxes, &mut pairs)?;
/// assert_eq!(pairs, [[0, 1]]);
/// # Ok::<(), unisize::InvalidInput>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct GridSweep<R, const D: usize> {
    /// The size classes of the last search, smallest boxes first.
    classes: Vec<Class<R, D>>,
    assignment: Assignment,
    /// Scratch: the members of a class, and those that it leaves to further ones.
    members: [Vec<u32>; 2],
    compared: u64,
}

impl<R: Real, const D: usize> PairFinder<R, D> for GridSweep<R, D> {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        pairs.clear();
        check_count(boxes.len(), MAX_BOXES)?;
        let work = match self.assignment.slabs_asked {
            Some(2..) => u64::MAX,
            _ => SEARCHED * boxes.len() as u64,
        };
        parallel::enter(work, || {
            let mut search = Search::new(boxes, None, usize::MAX, pairs);
            self.search(0..boxes.len() as u32, &mut search);
            self.compared = search.tally.compared;
        });
        // No class takes an invalid box.
        if !self.members[1].is_empty() {
            pairs.clear();
            check_boxes(boxes)?;
        }
        Ok(())
    }
}

impl<R: Real, const D: usize> GridSweep<R, D> {
    /// Returns a kernel that sorts and sweeps tubes in this many slabs, whatever the number of boxes and of threads: with more than one,
    /// threads share even a small number of boxes. The pairs are the same, in the same order. To use a single thread for everything, search
    /// in a Rayon pool of one.
    ///
    /// Above 16, there is at most one slab for every 64 boxes, so that memory stays **O(n + pairs)**.
    pub fn with_slabs(count: std::num::NonZero<usize>) -> Self {
        let mut kernel = Self::default();
        kernel.assignment.slabs_asked = Some(count.get());
        kernel
    }

    /// The comparisons of the last call of `find_pairs`, with visits of tubes in units of comparisons.
    #[doc(hidden)]
    pub fn compared(&self) -> u64 {
        self.compared
    }

    /// Appends the wanted pairs among `members`, which are indices of at most [`MAX_BOXES`] valid boxes, and `keeps` the members in order for
    /// [`look_up_queries`](Self::look_up_queries). `None` means that all pairs are wanted.
    ///
    /// Returns how many pairs overlap, wanted or not. If they are more than `most`, the search stops early and appends some of them,
    /// and nothing may be looked up.
    #[cfg(feature = "_adapter")]
    pub(crate) fn find_among(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: impl IntoIterator<Item = u32>,
        keeps: bool,
        wanted: Option<impl Fn([u32; 2]) -> bool + Sync>,
        most: usize,
        pairs: &mut Vec<[u32; 2]>,
    ) -> usize {
        debug_assert!(boxes.len() <= MAX_BOXES);
        let filter = wanted.map(filter);
        let mut search = Search::new(boxes, filter.as_ref().map(|f| f as _), most, pairs);
        search.keeps = keeps;
        self.search(members, &mut search);
        search.tally.emitted
    }

    /// Appends the wanted pairs among the boxes with these indices, class by class. Invalid ones remain in the second list of members.
    fn search(&mut self, indices: impl IntoIterator<Item = u32>, search: &mut Search<R, D>) {
        const { assert!(D > 0, "boxes have at least one axis") };
        let [members, oversized] = &mut self.members;
        members.clear();
        members.extend(indices);
        for count in 1..=MOST_CLASSES {
            self.classes
                .resize_with(count.max(self.classes.len()), Class::default);
            search.is_last_class = count == MOST_CLASSES;
            self.classes[count - 1].search(members, oversized, &mut self.assignment, search);
            if oversized.is_empty() || search.is_last_class || search.is_over() {
                self.classes.truncate(count);
                break;
            }
            std::mem::swap(members, oversized);
        }
        for (i, coarse) in self.classes.iter().enumerate() {
            for fine in &self.classes[..i] {
                if !search.is_over() {
                    fine.meet(coarse, search);
                }
            }
        }
    }

    /// Frees memory that only a search needs, and that is otherwise kept for the next one.
    pub(crate) fn free_scratch(&mut self) {
        self.assignment.parts = Vec::new();
        self.assignment.starts = Vec::new();
        self.members = Default::default();
        for slab in self.classes.iter_mut().flat_map(|class| &mut class.slabs) {
            slab.entries = Vec::new();
            slab.sorter = Default::default();
        }
    }

    /// Appends the wanted pairs of each query, an index of a valid box, with the members of the last search that its box overlaps.
    /// Members have the boxes that they had in that search. A query that is a member overlaps itself.
    ///
    /// Computes in about **O(log n + pairs)** time per query of the members' size; a larger query takes a binary search for each tube
    /// that it reaches. Stops early if more than `most` pairs overlap, wanted or not.
    pub(crate) fn look_up_queries(
        &self,
        boxes: &[Aabb<R, D>],
        queries: &[u32],
        wanted: impl Fn([u32; 2]) -> bool + Sync,
        most: usize,
        pairs: &mut Vec<[u32; 2]>,
    ) -> Tally {
        let filter = filter(wanted);
        let mut search = Search::new(boxes, Some(&filter), most, pairs);
        search.run_queries(queries, u64::MAX, |i, worker| {
            let classes = self.classes.iter();
            classes.for_each(|class| class.look_up(boxes, i, worker));
        });
        search.tally
    }
}

/// Removes the pairs from the given one on that are not wanted, without a branch.
fn filter(wanted: impl Fn([u32; 2]) -> bool + Sync) -> impl Fn(&mut Vec<[u32; 2]>, usize) + Sync {
    move |pairs, first| {
        let mut kept = first;
        for i in first..pairs.len() {
            let pair = pairs[i];
            pairs[kept] = pair;
            kept += usize::from(wanted(pair));
        }
        pairs.truncate(kept);
    }
}
