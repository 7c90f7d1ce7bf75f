//! The fast kernel: sorted tubes, swept eight boxes at a time.

mod ghosts;
mod grid;
mod lookup;
mod members;
mod order;
mod owner;
mod part;
mod scattered;
mod slab;
mod sweep;
#[cfg(test)]
mod tests;
mod tubes;

use crate::pair_finder::check_boxes;
use crate::stopwatch::{Phase, PhaseTimes, Stopwatch};
use crate::tuning::kernel::{ONE_TUBE_UP_TO, OUTSIZE_UP_TO_EIGHTHS, STRIP_WIDENINGS, THREADS_FROM};
use crate::{Aabb, InvalidInput, InvalidInputReason, PairFinder, Real, parallel};
use grid::Grid;
use members::{Everyone, Members};
use part::Part;
use scattered::Scattered;
use slab::Slab;
use sweep::Emitter;

/// Entries are numbered with 32 bits, and a box may have four.
const MAX_BOXES: usize = 1 << 29;

/// Cuts space into tubes along the first axis, sorts each by `mins[0]` and sweeps it.
///
/// The second and the third axis are cut into strips a few boxes wide. A box is entered in each tube that it spans,
/// usually one, and the pairs of each tube are found by comparing eight boxes at a time with those that follow them.
/// Boxes much larger than most are a class of their own, found by the same method on a coarser grid and looked up in
/// the finer one.
///
/// Exact for boxes of any sizes and in any dimension: the tubes decide only the speed. **O(n + pairs)** time for
/// boxes of about one size, in two and in three dimensions, times the logarithm of sorting where boxes are very
/// unevenly spread. The worst case is **O(n²)**: where small boxes crowd between borders that were chosen for larger
/// ones, where many large boxes span many tubes without touching anything there, or where boxes lie 10⁸ times their
/// size apart. **O(n + pairs)** memory always.
///
/// At most 2²⁹ boxes; more are refused as [`TooMany`](InvalidInputReason::TooMany).
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
#[derive(Clone, Debug)]
pub struct GridSweep<R, const D: usize> {
    /// The size classes of the last run, smallest first. Those past `class_count` are kept for their memory.
    classes: Vec<Class<R, D>>,
    class_count: usize,
    /// Scratch: the boxes of a class by tubes, a part for each thread.
    parts: Vec<Part>,
    /// The number of slabs, if it is fixed; otherwise many boxes are cut into as many slabs as there are threads.
    slab_count: Option<usize>,
    stopwatch: Stopwatch,
}

/// Refuses more boxes than there are numbers for their entries.
fn check_count(count: usize) -> Result<(), InvalidInput> {
    if count > MAX_BOXES {
        return Err(InvalidInput::new(MAX_BOXES, InvalidInputReason::TooMany));
    }
    Ok(())
}

/// The boxes of one size class, sorted into tubes.
#[derive(Clone, Debug)]
struct Class<R, const D: usize> {
    grid: Grid<R>,
    /// The first `slab_count` cover the grid. The others are kept for their memory.
    slabs: Vec<Slab<R, D>>,
    slab_count: usize,
    /// Scratch: the boxes by tubes, where there is no table of tubes.
    scattered: Scattered,
    /// The boxes too large for this class: the members of all following classes.
    outsize: Vec<u32>,
}

impl<R: Real, const D: usize> Default for Class<R, D> {
    fn default() -> Self {
        Self {
            grid: Grid::default(),
            slabs: Vec::new(),
            slab_count: 0,
            scattered: Scattered::default(),
            outsize: Vec::new(),
        }
    }
}

impl<R, const D: usize> Default for GridSweep<R, D> {
    fn default() -> Self {
        Self {
            classes: Vec::new(),
            class_count: 0,
            parts: Vec::new(),
            slab_count: None,
            stopwatch: Stopwatch::default(),
        }
    }
}

impl<R: Real, const D: usize> PairFinder<R, D> for GridSweep<R, D> {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        pairs.clear();
        check_count(boxes.len())?;
        self.stopwatch.times = PhaseTimes::default();
        let mut stopwatch = std::mem::take(&mut self.stopwatch);
        let are_valid = self.find(boxes, Everyone(boxes.len()), false, pairs, &mut stopwatch);
        stopwatch.leave();
        self.stopwatch = stopwatch;
        if are_valid {
            return Ok(());
        }
        pairs.clear();
        check_boxes(boxes)
    }
}

impl<R: Real, const D: usize> GridSweep<R, D> {
    /// A kernel that cuts its work into this many slabs of tubes, whatever the number of boxes and of threads: one
    /// to use no threads at all, or more to share a small number of boxes as well. The pairs are the same, in the
    /// same order.
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

    /// Appends the overlapping pairs among `members`, which are indices of valid boxes, and remembers the
    /// order of the members for [`look_up`](Self::look_up).
    ///
    /// # Errors
    /// [`InvalidInputReason::TooMany`] if there are more boxes than there are numbers for; then no pair is found, and no order
    /// remembered.
    #[cfg(feature = "_adapter")]
    pub(crate) fn find_among(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: &[u32],
        pairs: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) -> Result<(), InvalidInput> {
        self.class_count = 0;
        check_count(boxes.len())?;
        self.find(boxes, members, true, pairs, stopwatch);
        Ok(())
    }

    /// Appends the overlapping pairs among the members, and says whether their boxes are valid; if not, what has been
    /// appended is unspecified.
    fn find(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: impl Members,
        keeps: bool,
        pairs: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) -> bool {
        const { assert!(D > 0, "boxes have at least one axis") };
        self.class_count = 0;
        let slab_count = match self.slab_count {
            Some(count) => count,
            None if members.count() < THREADS_FROM => 1,
            None => parallel::threads(),
        };
        if !self.find_in_class(boxes, members, slab_count, keeps, pairs, stopwatch) {
            return false;
        }
        loop {
            let class = &mut self.classes[self.class_count - 1];
            if class.outsize.is_empty() {
                return true;
            }
            let outsize = std::mem::take(&mut class.outsize);
            self.find_in_class(boxes, &outsize[..], slab_count, keeps, pairs, stopwatch);
            self.classes[self.class_count - 2].outsize = outsize;
        }
    }

    /// Appends the overlapping pairs of a class, and those of its members with what is too large for it.
    fn find_in_class(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: impl Members,
        slab_count: usize,
        keeps: bool,
        pairs: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) -> bool {
        if self.class_count == self.classes.len() {
            self.classes.push(Class::default());
        }
        let class = &mut self.classes[self.class_count];
        let dealt = class.deal(boxes, members, slab_count, &mut self.parts, stopwatch);
        let Some(part_count) = dealt else {
            return false;
        };
        self.class_count += 1;
        let parts = &self.parts[..part_count];
        class.find(boxes, parts, slab_count, keeps, pairs, stopwatch);
        if !class.outsize.is_empty() {
            stopwatch.enter(Phase::Sweep);
            class.prepare_lookup();
            let mut emitter = Emitter::new(pairs);
            for &i in &class.outsize {
                class.look_up(&boxes[i as usize], i, &mut emitter);
            }
            emitter.finish();
            stopwatch.leave();
        }
        true
    }

    /// The number of size classes in the last run.
    #[cfg(feature = "_adapter")]
    pub(crate) fn class_count(&self) -> usize {
        self.class_count
    }

    /// The strips of the first class in the last run, along each of the axes that are cut.
    #[cfg(feature = "_adapter")]
    pub(crate) fn strips(&self) -> [u32; 2] {
        let class = self.classes[..self.class_count].first();
        class.map_or([0; 2], |class| {
            class.grid.axes.map(|axis| axis.last.saturating_add(1))
        })
    }

    /// Prepares for [`look_up`](Self::look_up), until the next run.
    #[cfg(feature = "_adapter")]
    pub(crate) fn prepare_lookup(&mut self) {
        for class in &mut self.classes[..self.class_count] {
            class.prepare_lookup();
        }
    }

    /// Frees what only a run needs, and is otherwise kept for the next one.
    #[cfg(feature = "_adapter")]
    pub(crate) fn free_scratch(&mut self) {
        self.parts = Vec::new();
        self.classes.truncate(self.class_count);
        for class in &mut self.classes {
            class.scattered = Scattered::default();
            class.slabs.truncate(class.slab_count);
            class.slabs.iter_mut().for_each(Slab::free_scratch);
        }
    }

    /// Appends the pairs of each query, an index of a valid box, with the members of the last run that its box
    /// overlaps. Members have the boxes that they had then; the pair of a member with itself is not left out.
    ///
    /// About **O(log n + pairs)** for a query of the size of the members; a larger one costs a binary search for
    /// each tube that it spans.
    #[cfg(feature = "_adapter")]
    pub(crate) fn look_up(
        &self,
        boxes: &[Aabb<R, D>],
        queries: impl Iterator<Item = u32>,
        pairs: &mut Vec<[u32; 2]>,
    ) {
        let mut emitter = Emitter::new(pairs);
        for i in queries {
            for class in &self.classes[..self.class_count] {
                class.look_up(&boxes[i as usize], i, &mut emitter);
            }
        }
        emitter.finish();
    }
}

impl<R: Real, const D: usize> Class<R, D> {
    /// Chooses a grid and deals the members to its tubes, except the outsize ones: to `parts`, whose number is returned, or, if
    /// that is 0, to [`Scattered`]. None if a box is invalid; then nothing is dealt.
    ///
    /// Each class must take a fair share of the boxes, so that there are few classes. If a grid turns out to be too
    /// fine for that, wider ones are tried, and in the end a single tube, for which nothing is outsize.
    fn deal<M: Members>(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: M,
        slab_count: usize,
        parts: &mut Vec<Part>,
        stopwatch: &mut Stopwatch,
    ) -> Option<usize> {
        let count = members.count();
        let mut widenings = match count {
            ..=ONE_TUBE_UP_TO => [].iter(),
            _ => STRIP_WIDENINGS.iter(),
        };
        loop {
            stopwatch.enter(Phase::Read);
            let widening = widenings.next();
            let mut part_count = 1;
            self.grid = Grid::default();
            if let Some(&widening) = widening {
                part_count = slab_count.clamp(1, count);
                self.grid = Grid::choose(boxes, members, widening);
                if !self.grid.fits_table(count) {
                    let cut_once = self.grid.cut_once(boxes, members);
                    self.grid = cut_once.unwrap_or(self.grid);
                }
            }
            self.outsize.clear();
            if !self.grid.fits_table(count) {
                part_count = 0;
                let mut is_valid = true;
                if M::MAY_BE_INVALID {
                    members.for_each(boxes, 0..count, |_, _, aabb| is_valid &= aabb.is_valid());
                }
                if !is_valid {
                    return None;
                }
                stopwatch.enter(Phase::Sort);
                self.grid.extend::<D>();
                self.scattered
                    .deal(boxes, members, &self.grid, &mut self.outsize);
                stopwatch.enter(Phase::Read);
            }
            if parts.len() < part_count {
                parts.resize_with(part_count, Part::default);
            }
            let parts = &mut parts[..part_count];
            for (i, part) in parts.iter_mut().enumerate() {
                part.range = i * count / part_count..(i + 1) * count / part_count;
            }
            let grid = &self.grid;
            parallel::for_each(parts, |part| part.count(boxes, members, grid));
            if !parts.iter().all(|part| !part.is_invalid) {
                return None;
            }
            for part in &mut *parts {
                self.outsize.append(&mut part.outsize);
            }
            if widening.is_none() || self.outsize.len() <= count / 8 * OUTSIZE_UP_TO_EIGHTHS {
                stopwatch.enter(Phase::Sort);
                parallel::for_each(parts, |part| part.place(members));
                stopwatch.leave();
                return Some(part_count);
            }
        }
    }

    /// Sorts and sweeps the tubes, and appends the pairs. The tubes stay if `keeps` asks for it, or there are outsize boxes to
    /// look up in them.
    fn find(
        &mut self,
        boxes: &[Aabb<R, D>],
        parts: &[Part],
        slab_count: usize,
        keeps: bool,
        pairs: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) {
        let keeps = keeps || !self.outsize.is_empty();
        let Self {
            grid, scattered, ..
        } = self;
        let ranges = match parts {
            [] => std::iter::once(0..u32::MAX).collect(),
            _ => slab::split(grid, parts, slab_count),
        };
        self.slab_count = ranges.len();
        if self.slabs.len() < ranges.len() {
            self.slabs.resize_with(ranges.len(), Slab::default);
        }
        for (slab, range) in self.slabs.iter_mut().zip(ranges) {
            slab.tubes.clear(range);
            slab.stopwatch = stopwatch.reset();
        }
        match &mut self.slabs[..self.slab_count] {
            [slab] if parts.is_empty() => slab.find_scattered(boxes, scattered, keeps, pairs),
            [slab] => slab.find(boxes, grid, parts, keeps, pairs),
            slabs => {
                // The first one need not copy its pairs.
                std::mem::swap(&mut slabs[0].pairs, pairs);
                parallel::for_each(slabs, |slab| {
                    let mut pairs = std::mem::take(&mut slab.pairs);
                    slab.find(boxes, grid, parts, keeps, &mut pairs);
                    slab.pairs = pairs;
                });
                std::mem::swap(&mut slabs[0].pairs, pairs);
                for slab in &mut slabs[1..] {
                    pairs.append(&mut slab.pairs);
                }
            }
        }
        // They have worked at the same time.
        for slab in &self.slabs[..self.slab_count] {
            let PhaseTimes { sort, sweep, .. } = slab.stopwatch.times;
            stopwatch.times.sort += sort / self.slab_count as u32;
            stopwatch.times.sweep += sweep / self.slab_count as u32;
        }
    }

    fn slabs(&self) -> &[Slab<R, D>] {
        &self.slabs[..self.slab_count]
    }

    fn prepare_lookup(&mut self) {
        if self.slabs().iter().all(|slab| slab.tubes.is_prepared()) {
            return;
        }
        parallel::for_each(&mut self.slabs[..self.slab_count], |slab| {
            slab.tubes.prepare_lookup();
        });
    }

    fn look_up(&self, aabb: &Aabb<R, D>, owner: u32, emitter: &mut Emitter) {
        for slab in self.slabs() {
            slab.tubes.look_up(&self.grid, aabb, owner, emitter);
        }
    }
}
