//! One size class: its boxes are assigned to the tubes of a grid, and each tube is sorted and swept.

use super::assignment::Assignment;
use super::emitter::Emitter;
use super::grid::Grid;
use super::lookup::Query;
use super::members::Members;
use super::owner::Owner;
use super::slab::Slab;
use crate::aabb::Aabb;
use crate::parallel::Section;
use crate::real::Real;
use crate::stopwatch::{Phase, PhaseTimes, Stopwatch};
use crate::tuning::kernel::{
    LOOK_UP_SMALL_FROM, ONE_TUBE_UP_TO, OVERSIZED_UP_TO_EIGHTHS, STRIP_WIDENINGS,
};
use crate::tuning::prices::{LOOKED_UP, SLOT};

/// What a run of the kernel works with, in every class.
pub(super) struct Run<'a, R, const D: usize, F> {
    pub(super) boxes: &'a [Aabb<R, D>],
    /// How many slabs the work is cut into, at most, if that is fixed.
    pub(super) slab_count: Option<usize>,
    /// The work on the members of the class.
    pub(super) section: Section,
    /// Whether boxes will be looked up when the run is over.
    pub(super) keeps: bool,
    pub(super) pairs: &'a mut Vec<[u32; 2]>,
    /// Which pairs are wanted; `None`: all.
    pub(super) wanted: Option<F>,
    /// How many pairs were found that are not.
    pub(super) unwanted: usize,
    pub(super) stopwatch: &'a mut Stopwatch,
}

/// A box is invalid: what has been found is unspecified.
pub(super) struct FoundInvalid;

/// The boxes of one size class, sorted into tubes.
#[derive(Clone, Debug, Default)]
pub(super) struct Class<R, const D: usize> {
    pub(super) grid: Grid<R>,
    /// Together they cover the grid.
    pub(super) slabs: Vec<Slab<R, D>>,
    /// The boxes too large for this class: the members of all following classes.
    pub(super) oversized: Vec<u32>,
    /// The boxes of this class, if they are to be looked up in the following classes, and not those here.
    pub(super) seekers: Vec<u32>,
}

impl<R: Real, const D: usize> Class<R, D> {
    /// Chooses a grid and assigns the members to its tubes, except the oversized ones.
    ///
    /// Each class must take a fair share of the boxes, so that there are few classes. If a grid turns out to be too
    /// fine for that, wider ones are tried, and in the end a single tube, for which nothing is oversized.
    pub(super) fn assign<F>(
        &mut self,
        members: impl Members,
        assignment: &mut Assignment,
        run: &mut Run<R, D, F>,
    ) -> Result<(), FoundInvalid> {
        let count = members.count();
        let widenings = match count {
            ..=ONE_TUBE_UP_TO => &[],
            _ => &STRIP_WIDENINGS[..],
        };
        for widening in widenings.iter().map(Some).chain([None]) {
            run.stopwatch.enter(Phase::Read);
            self.grid = match widening {
                Some(&widening) => Grid::choose(run.boxes, members, widening),
                None => Grid::default(),
            };
            assignment.count(members, &mut self.grid, run);
            self.oversized.clear();
            for part in &mut assignment.parts {
                if part.is_invalid {
                    return Err(FoundInvalid);
                }
                self.oversized.append(&mut part.oversized);
            }
            if self.oversized.len() <= count / 8 * OVERSIZED_UP_TO_EIGHTHS {
                break;
            }
        }
        run.stopwatch.enter(Phase::Sort);
        assignment.place(members, run.section);
        run.stopwatch.leave();
        Ok(())
    }

    /// Sorts and sweeps the tubes, and appends the pairs. The tubes stay if the run asks for it, or if boxes are looked up in them: those
    /// of finer classes, if it `is_sought`, or oversized ones.
    pub(super) fn sweep<F: Fn([u32; 2]) -> bool + Sync>(
        &mut self,
        assignment: &Assignment,
        is_sought: bool,
        run: &mut Run<R, D, F>,
    ) {
        let (boxes, slabs) = (run.boxes, &mut self.slabs);
        let keeps = run.keeps || is_sought || !self.oversized.is_empty();
        let ranges = assignment.split();
        slabs.resize_with(ranges.len(), Slab::default);
        for (slab, range) in slabs.iter_mut().zip(ranges) {
            slab.tubes.clear(range, assignment.columns);
            slab.stopwatch = run.stopwatch.reset();
        }
        // The first one need not copy its pairs.
        std::mem::swap(&mut slabs[0].pairs, run.pairs);
        let wanted = run.wanted.as_ref();
        run.section.for_each(slabs, |slab| {
            let first = slab.pairs.len();
            slab.sweep(boxes, assignment, keeps);
            slab.unwanted = drop_unwanted(&mut slab.pairs, first, wanted);
        });
        std::mem::swap(&mut slabs[0].pairs, run.pairs);
        for slab in &mut slabs[1..] {
            run.pairs.append(&mut slab.pairs);
        }
        run.unwanted += slabs.iter().map(|slab| slab.unwanted).sum::<usize>();
        // They have worked at the same time.
        for slab in &*slabs {
            let PhaseTimes { sort, sweep, .. } = slab.stopwatch.times;
            run.stopwatch.times.sort += sort / slabs.len() as u32;
            run.stopwatch.times.sweep += sweep / slabs.len() as u32;
        }
    }

    /// Appends the pairs of the oversized boxes with those of the class, unless it is cheaper to look these up among the oversized ones
    /// later.
    pub(super) fn look_up_oversized<F: Fn([u32; 2]) -> bool + Sync>(
        &mut self,
        run: &mut Run<R, D, F>,
    ) {
        self.seekers.clear();
        if self.oversized.is_empty() {
            return;
        }
        if self.spanned(run.boxes) > LOOK_UP_SMALL_FROM * self.entries().count() as u64 {
            let mut seekers = std::mem::take(&mut self.seekers);
            let at_home = self.entries().filter(|owner| owner.is_at_home());
            seekers.extend(at_home.map(|owner| owner.index()));
            self.seekers = seekers;
            return;
        }
        let oversized = std::mem::take(&mut self.oversized);
        self.look_up_all(&oversized, run);
        self.oversized = oversized;
    }

    /// The owners of all entries.
    fn entries(&self) -> impl Iterator<Item = Owner> + '_ {
        self.slabs.iter().flat_map(|slab| slab.tubes.entries())
    }

    /// How many tubes the oversized boxes would have to be looked up in, at most.
    fn spanned(&self, boxes: &[Aabb<R, D>]) -> u64 {
        let tubes: usize = self.slabs.iter().map(|slab| slab.tubes.tubes.len()).sum();
        let spans = self.oversized.iter();
        let spans = spans.map(|&i| self.grid.tube_span(&boxes[i as usize]));
        spans.map(|span| span.count().min(tubes as u64)).sum()
    }

    /// Appends the pairs of boxes of other classes with those of this one.
    pub(super) fn look_up_all<F: Fn([u32; 2]) -> bool + Sync>(
        &mut self,
        queries: &[u32],
        run: &mut Run<R, D, F>,
    ) {
        run.stopwatch.enter(Phase::Sweep);
        self.prepare_lookup();
        let boxes = run.boxes;
        let wanted = run.wanted.as_ref();
        run.unwanted += look_up_in_parts(queries, run.pairs, wanted, |i, emitter| {
            self.look_up(&boxes[i as usize], i, emitter);
        });
        run.stopwatch.leave();
    }

    /// Prepares for [`look_up`](Self::look_up), until the next run.
    pub(super) fn prepare_lookup(&mut self) {
        if !self.slabs.iter().all(|slab| slab.tubes.is_prepared()) {
            let entries = self.slabs.iter().map(|slab| slab.tubes.owners.len()).sum();
            let section = Section::of(entries, SLOT);
            section.for_each(&mut self.slabs, |slab| slab.tubes.prepare_lookup());
        }
    }

    /// Emits the pair of a box with every box of the class that it overlaps.
    pub(super) fn look_up(&self, aabb: &Aabb<R, D>, index: u32, emitter: &mut Emitter) {
        let span = self.grid.tube_span(aabb);
        let query = Query { aabb, index, span };
        for slab in &self.slabs {
            slab.tubes.look_up(&query, emitter);
        }
    }
}

/// Appends what is found for each query, if it is wanted, in the order of the queries, by several threads if they are many. Returns how
/// many pairs are not.
pub(super) fn look_up_in_parts(
    queries: &[u32],
    pairs: &mut Vec<[u32; 2]>,
    wanted: Option<&(impl Fn([u32; 2]) -> bool + Sync)>,
    look_up: impl Fn(u32, &mut Emitter) + Sync,
) -> usize {
    let section = Section::of(queries.len(), LOOKED_UP);
    let queries_a_part = queries.len().div_ceil(section.parts()).max(1);
    let parts = queries.chunks(queries_a_part);
    let mut parts: Vec<_> = parts.map(|queries| (queries, Vec::new(), 0)).collect();
    if let [(_, found, _), ..] = &mut parts[..] {
        // The first one need not copy its pairs.
        std::mem::swap(found, pairs);
    }
    section.for_each(&mut parts, |(queries, found, unwanted)| {
        let first = found.len();
        let mut emitter = Emitter::new(found);
        queries.iter().for_each(|&i| look_up(i, &mut emitter));
        emitter.finish();
        *unwanted = drop_unwanted(found, first, wanted);
    });
    let unwanted = parts.iter().map(|(_, _, unwanted)| unwanted).sum();
    let mut parts = parts.into_iter().map(|(_, found, _)| found);
    if let Some(first) = parts.next() {
        *pairs = first;
    }
    parts.for_each(|found| pairs.extend(found));
    unwanted
}

/// Drops the pairs from `first` on that are not wanted. Returns how many.
fn drop_unwanted(
    pairs: &mut Vec<[u32; 2]>,
    first: usize,
    wanted: Option<impl Fn([u32; 2]) -> bool>,
) -> usize {
    let count = pairs.len();
    if let Some(wanted) = wanted {
        retain_from(pairs, first, wanted);
    }
    count - pairs.len()
}

/// Drops the pairs from `first` on that do not meet the condition, without a branch.
#[inline(always)]
pub(crate) fn retain_from(
    pairs: &mut Vec<[u32; 2]>,
    first: usize,
    keep: impl Fn([u32; 2]) -> bool,
) {
    let mut kept = first;
    for i in first..pairs.len() {
        let pair = pairs[i];
        pairs[kept] = pair;
        kept += usize::from(keep(pair));
    }
    pairs.truncate(kept);
}
