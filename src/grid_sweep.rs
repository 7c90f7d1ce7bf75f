//! The fast kernel: sorted tubes, swept eight boxes at a time.

mod assignment;
mod choose;
mod class;
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
use crate::tuning::prices::SEARCHED;
use assignment::Assignment;
pub(crate) use class::retain_from;
use class::{Class, FoundInvalid, Run, look_up_in_parts};
use members::{Everyone, Members};

/// Entries are numbered with 32 bits, and a box may have four.
pub(crate) const MAX_BOXES: usize = 1 << 29;

/// Cuts space into tubes along the first axis, sorts each by `mins[0]` and sweeps it.
///
/// The second and the third axis are cut into strips a few boxes wide. A box is entered in each tube that it spans,
/// usually one, and the pairs of each tube are found by comparing eight boxes at a time with those that follow them.
/// Boxes much larger than most are a class of their own, found by the same method on a coarser grid. Where they span few tubes of the
/// finer one, they are looked up in it; where they span many, as walls do, the boxes of the finer class are looked up among them.
///
/// Exact for boxes of any sizes and in any dimension: the tubes decide only the speed. **O(n + pairs)** time for
/// boxes of about one size and walls among them, in two and in three dimensions, times the logarithm of sorting where boxes are very
/// unevenly spread. The worst case is **O(n²)**: where small boxes crowd between borders that were chosen for larger
/// ones, or where boxes lie 10⁸ times their size apart. **O(n + pairs)** memory always.
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
    /// The number of slabs, if it is fixed; otherwise many boxes are cut into as many slabs as there are threads.
    slab_count: Option<usize>,
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
            self.run(
                members,
                &mut Run {
                    boxes,
                    slab_count: self.slab_count,
                    section: Section::default(),
                    keeps: false,
                    pairs,
                    wanted: None::<fn([u32; 2]) -> bool>,
                    unwanted: 0,
                    stopwatch: &mut stopwatch,
                },
            )
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

    /// Appends the overlapping pairs among `members`, which are indices of valid boxes, that are wanted, and remembers the
    /// order of the members for [`look_up`](Self::look_up). There must be no more than [`MAX_BOXES`]. Returns how many pairs were not
    /// wanted; if no condition is given, all are.
    #[cfg(feature = "_adapter")]
    pub(crate) fn find_among(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: &[u32],
        wanted: Option<impl Fn([u32; 2]) -> bool + Sync>,
        pairs: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) -> usize {
        debug_assert!(boxes.len() <= MAX_BOXES);
        let mut run = Run {
            boxes,
            slab_count: self.slab_count,
            section: Section::default(),
            keeps: true,
            pairs,
            wanted,
            unwanted: 0,
            stopwatch,
        };
        // The boxes are valid.
        let _ = self.run(members, &mut run);
        run.unwanted
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
            if class.oversized.is_empty() {
                return Ok(());
            }
            let oversized = std::mem::take(&mut class.oversized);
            self.run_class(&oversized[..], run)?;
            self.classes[self.class_count - 2].oversized = oversized;
        }
    }

    /// Appends the overlapping pairs of the next class, and those of its members with what is too large for it.
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
        self.class_count += 1;
        let (finer, rest) = self.classes.split_at_mut(self.class_count - 1);
        let class = &mut rest[0];
        let seekers = finer.iter().map(|class| &class.seekers[..]);
        class.sweep(
            &self.assignment,
            seekers.clone().any(|seekers| !seekers.is_empty()),
            run,
        );
        seekers.for_each(|seekers| class.look_up_all(seekers, run));
        class.look_up_oversized(run);
        Ok(())
    }

    /// The number of size classes in the last run.
    pub(crate) fn class_count(&self) -> usize {
        self.class_count
    }

    /// The strips of the first class in the last run, along each of the axes that are cut.
    pub(crate) fn strips(&self) -> [u32; 2] {
        let class = self.classes[..self.class_count].first();
        class.map_or([0; 2], |class| {
            class.grid.axes.map(|axis| axis.last.saturating_add(1))
        })
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
        let classes = self.classes.iter_mut();
        classes.for_each(|class| class.seekers = Vec::new());
    }

    /// Appends the pairs of each query, an index of a valid box, with the members of the last run that its box
    /// overlaps, if they are wanted. Members have the boxes that they had then; the pair of a member with itself is not left out.
    ///
    /// About **O(log n + pairs)** for a query of the size of the members; a larger one costs a binary search for
    /// each tube that it spans.
    pub(crate) fn look_up(
        &self,
        boxes: &[Aabb<R, D>],
        queries: &[u32],
        wanted: impl Fn([u32; 2]) -> bool + Sync,
        pairs: &mut Vec<[u32; 2]>,
    ) {
        look_up_in_parts(queries, pairs, Some(&wanted), |i, emitter| {
            let aabb = &boxes[i as usize];
            for class in &self.classes[..self.class_count] {
                class.look_up(aabb, i, emitter);
            }
        });
    }
}
