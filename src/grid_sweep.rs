//! The fast kernel: sorted tubes, swept eight boxes at a time.

mod assignment;
mod choose;
mod class;
mod crowd;
mod emitter;
mod grid;
mod lookup;
mod members;
mod order;
mod owner;
mod part;
mod slab;
mod sweep;
#[cfg(test)]
mod tests;
mod tubes;

use crate::aabb::Aabb;
use crate::invalid_input::InvalidInput;
use crate::pair_finder::{PairFinder, check_boxes, check_count};
use crate::parallel::{self, Section};
use crate::real::Real;
use crate::stopwatch::{PhaseTimes, Stopwatch};
use crate::tuning::kernel::FEW_QUERIES;
use crate::tuning::prices::SEARCHED;
use assignment::Assignment;
#[cfg(feature = "_adapter")]
use class::{Class, FoundInvalid, Run, look_up_in_parts};
use emitter::{Emitter, Tally};
use members::{Everyone, Members};

/// Entries are numbered with 32 bits, and a box may have four.
pub(crate) const MAX_BOXES: usize = 1 << 29;

/// Cuts space into tubes along the first axis, sorts each by `mins[0]` and sweeps it.
///
/// The second and the third axis are cut into strips a few boxes wide. A box is entered in each tube that it spans,
/// usually one, and the pairs of each tube are found by comparing eight boxes at a time with those that follow them.
/// Boxes much larger than most are a class of their own, found by the same method on a coarser grid. For each two classes, the boxes of one
/// are looked up in the other, in whichever direction a sample takes less. Boxes that crowd in one tube, because they are much smaller than
/// most or lie where few others do, have a grid of their own.
///
/// Exact for boxes of any sizes and in any dimension: the tubes decide only the speed. **O((n + pairs) log n)** time where the boxes of each
/// size lie no denser than so many deep, whatever sizes there are and wherever they lie: a class takes at least an eighth of the boxes that
/// are left, and a grid within a grid leaves at most a quarter of the comparisons. Plates and needles that cross each other's way without
/// touching have the largest constant: each is looked up in the tubes that it spans. **O(n + pairs)** memory always.
///
/// At most 2²⁹ boxes; more are refused as [`TooMany`](crate::InvalidInputReason::TooMany).
///
/// With the feature `parallel`, the work on many boxes is shared among the threads of the current Rayon pool. The
/// pairs are the same, in the same order.
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
    /// The size classes of the last run, smallest first. Those past `class_count` are kept for their memory.
    classes: Vec<Class<R, D>>,
    class_count: usize,
    assignment: Assignment,
    /// Scratch: the members of two classes.
    members: [Vec<u32>; 2],
    /// The number of slabs, if it is fixed; otherwise many boxes are cut into as many slabs as there are threads.
    slab_count: Option<usize>,
    compared: usize,
    stopwatch: Stopwatch,
}

impl<R: Real, const D: usize> PairFinder<R, D> for GridSweep<R, D> {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        pairs.clear();
        check_count(boxes.len(), MAX_BOXES)?;
        let mut stopwatch = self.stopwatch.reset();
        let members = Everyone(boxes.len());
        let work = SEARCHED * boxes.len() as u64;
        let found = parallel::enter(work, || {
            let mut run = Run {
                boxes,
                is_crowd: false,
                slab_count: self.slab_count,
                section: Section::default(),
                keeps: false,
                pairs,
                wanted: None::<fn([u32; 2]) -> bool>,
                most: usize::MAX,
                tally: Tally::default(),
                stopwatch: &mut stopwatch,
            };
            let found = self.run(members, &mut run);
            self.compared = run.tally.compared;
            found
        });
        stopwatch.leave();
        self.stopwatch = stopwatch;
        found.or_else(|FoundInvalid| {
            pairs.clear();
            check_boxes(boxes)
        })
    }
}

impl<R: Real, const D: usize> GridSweep<R, D> {
    /// A kernel that cuts its work into this many slabs of tubes, whatever the number of boxes and of threads: one
    /// to use no threads at all, or more to share a small number of boxes as well. The pairs are the same, in the
    /// same order.
    ///
    /// More than 16 slabs are fewer where they would have less than 64 boxes each, so that memory stays **O(n + pairs)**.
    pub fn with_slabs(count: std::num::NonZero<usize>) -> Self {
        Self {
            slab_count: Some(count.get()),
            ..Self::default()
        }
    }

    /// The same kernel, which from now on takes the [times of its phases](Self::phase_times).
    pub fn timed(self) -> Self {
        Self {
            stopwatch: Stopwatch::new(true),
            ..self
        }
    }

    /// How long each phase of the last run has taken; zeros unless it was [`timed`](Self::timed).
    pub fn phase_times(&self) -> PhaseTimes {
        self.stopwatch.times
    }

    /// How many boxes the last run has compared with another, and how many tubes it has visited to look boxes up.
    #[doc(hidden)]
    pub fn compared(&self) -> usize {
        self.compared
    }

    /// Appends the overlapping pairs among `members`, which are indices of valid boxes, that are wanted, and remembers the
    /// order of the members for [`look_up`](Self::look_up). There must be no more than [`MAX_BOXES`]. If no condition is given, all pairs
    /// are wanted. Returns how many pairs overlap, wanted or not; if they are more than `most`, the run stops early, appends some of them,
    /// and nothing may be looked up.
    #[cfg(feature = "_adapter")]
    pub(crate) fn find_among(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: &[u32],
        wanted: Option<impl Fn([u32; 2]) -> bool + Sync>,
        most: usize,
        pairs: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) -> usize {
        debug_assert!(boxes.len() <= MAX_BOXES);
        let mut run = Run {
            boxes,
            is_crowd: false,
            slab_count: self.slab_count,
            section: Section::default(),
            keeps: true,
            pairs,
            wanted,
            most,
            tally: Tally::default(),
            stopwatch,
        };
        // The boxes are valid.
        let _ = self.run(members, &mut run);
        run.tally.emitted
    }

    /// Appends the overlapping pairs among the members, class by class.
    fn run<F: Fn([u32; 2]) -> bool + Sync>(
        &mut self,
        members: impl Members,
        run: &mut Run<R, D, F>,
    ) -> Result<(), FoundInvalid> {
        const { assert!(D > 0, "boxes have at least one axis") };
        self.class_count = 0;
        self.run_class(members, run)?;
        loop {
            let class = &mut self.classes[self.class_count - 1];
            if class.oversized.is_empty() || run.is_over() {
                break;
            }
            let oversized = std::mem::take(&mut class.oversized);
            self.run_class(&oversized[..], run)?;
            self.classes[self.class_count - 2].oversized = oversized;
        }
        for coarse in 1..self.class_count {
            for fine in 0..coarse {
                if run.is_over() {
                    return Ok(());
                }
                self.match_classes(fine, coarse, run);
            }
        }
        Ok(())
    }

    /// Appends the overlapping pairs of the next class.
    fn run_class<F: Fn([u32; 2]) -> bool + Sync>(
        &mut self,
        members: impl Members,
        run: &mut Run<R, D, F>,
    ) -> Result<(), FoundInvalid> {
        if self.class_count == self.classes.len() {
            self.classes.push(Class::default());
        }
        let class = &mut self.classes[self.class_count];
        run.section = Section::of(members.count(), SEARCHED);
        class.assign(members, &mut self.assignment, run)?;
        class.sweep(&self.assignment, self.class_count == 0, run);
        self.class_count += 1;
        Ok(())
    }

    /// Appends the pairs of the boxes of one class with those of another. Looks up those of which fewer look-ups, or faster ones, are to be
    /// expected: of a few, for certain; of many, by a sample.
    fn match_classes<F: Fn([u32; 2]) -> bool + Sync>(
        &mut self,
        fine: usize,
        coarse: usize,
        run: &mut Run<R, D, F>,
    ) {
        let [finer, coarser] = &mut self.members;
        self.classes[coarse].list_members(coarser);
        let (left, right) = self.classes.split_at_mut(coarse);
        let (fine, coarse) = (&mut left[fine], &mut right[0]);
        fine.prepare_lookup();
        if coarser.len() > FEW_QUERIES {
            coarse.prepare_lookup();
            fine.list_members(finer);
            if coarse.effort(finer, run.boxes) < fine.effort(coarser, run.boxes) {
                return coarse.look_up_all(finer, run);
            }
        }
        fine.look_up_all(coarser, run);
    }

    /// The number of size classes in the last run.
    pub(crate) fn class_count(&self) -> usize {
        self.class_count
    }

    /// Prepares for [`look_up`](Self::look_up), until the next run.
    pub(crate) fn prepare_lookup(&mut self) {
        for class in &mut self.classes[..self.class_count] {
            class.prepare_lookup();
        }
    }

    /// Frees what only a run needs, and is otherwise kept for the next one.
    pub(crate) fn free_scratch(&mut self) {
        self.assignment = Assignment::default();
        self.classes.truncate(self.class_count);
        let slabs = self.classes.iter_mut().flat_map(|class| &mut class.slabs);
        slabs.for_each(|slab| slab.free_scratch());
        self.members = Default::default();
    }

    /// Appends the pairs of each query, an index of a valid box, with the members of the last run that its box
    /// overlaps, if they are wanted. Members have the boxes that they had then; the pair of a member with itself is not left out.
    ///
    /// About **O(log n + pairs)** for a query of the size of the members; a larger one costs a binary search for
    /// each tube that it spans. Stops when there are more than `most` pairs, wanted or not.
    pub(crate) fn look_up(
        &self,
        boxes: &[Aabb<R, D>],
        queries: &[u32],
        wanted: impl Fn([u32; 2]) -> bool + Sync,
        most: usize,
        pairs: &mut Vec<[u32; 2]>,
    ) -> Tally {
        look_up_in_parts(queries, pairs, Some(&wanted), most, |i, emitter| {
            self.look_up_box(&boxes[i as usize], i, emitter);
        })
    }

    /// Emits the pair of a box with every member that it overlaps.
    fn look_up_box(&self, aabb: &Aabb<R, D>, index: u32, emitter: &mut Emitter) {
        for class in &self.classes[..self.class_count] {
            class.look_up(aabb, index, emitter);
        }
    }
}
