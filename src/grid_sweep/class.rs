//! One size class: its boxes are assigned to the tubes of a grid, and each tube is sorted and swept.

use super::assignment::Assignment;
use super::choose::sample_indices;
use super::emitter::{Emitter, Tally};
use super::grid::{Grid, TubeSpan};
use super::lookup::Query;
use super::members::Members;
use super::slab::Slab;
use crate::aabb::Aabb;
use crate::parallel::Section;
use crate::real::Real;
use crate::stopwatch::{Phase, PhaseTimes, Stopwatch};
use crate::tuning::kernel::{
    CROWD_SIZE_QUANTILES, EFFORT_SAMPLE, GRID_SIZE_QUANTILE, ONE_TUBE_UP_TO, QUERY,
};
use crate::tuning::prices::{LOOKED_UP, SLOT};

/// What a run of the kernel works with, in every class.
pub(super) struct Run<'a, R, const D: usize, F> {
    pub(super) boxes: &'a [Aabb<R, D>],
    /// Whether the boxes are of a single tube of another grid.
    pub(super) is_crowd: bool,
    /// How many slabs the work is cut into, at most, if that is fixed.
    pub(super) slab_count: Option<usize>,
    /// The work on the members of the class.
    pub(super) section: Section,
    /// Whether boxes will be looked up when the run is over.
    pub(super) keeps: bool,
    pub(super) pairs: &'a mut Vec<[u32; 2]>,
    /// Which pairs are wanted; `None`: all.
    pub(super) wanted: Option<F>,
    /// How many pairs may be found, wanted or not. If there are more, the run stops, and has found some of them.
    pub(super) most: usize,
    pub(super) tally: Tally,
    pub(super) stopwatch: &'a mut Stopwatch,
}

impl<R, const D: usize, F> Run<'_, R, D, F> {
    /// How many more pairs may be found.
    fn room(&self) -> usize {
        self.most.saturating_sub(self.tally.emitted)
    }

    /// Whether more pairs were found than may be. That does not depend on the number of slabs.
    pub(super) fn is_over(&self) -> bool {
        self.tally.emitted > self.most
    }
}

/// A box is invalid: what has been found is unspecified.
pub(super) struct FoundInvalid;

/// The boxes of one size class, sorted into tubes.
#[derive(Clone, Debug, Default)]
pub(super) struct Class<R, const D: usize> {
    pub(super) grid: Grid<R>,
    /// Together they cover the grid.
    pub(super) slabs: Vec<Slab<R, D>>,
    /// A box around those of this class, if boxes are looked up; and the first strips that it spans, if all its tubes have numbers of their
    /// own.
    bounds: Option<(Aabb<R, D>, Option<[u32; 2]>)>,
    /// Whether the grid was chosen for the boxes, and suits them.
    is_separated: bool,
    /// The boxes too large for this class: the members of all following classes.
    pub(super) oversized: Vec<u32>,
}

impl<R: Real, const D: usize> Class<R, D> {
    /// Chooses a grid and assigns the members to its tubes, except the oversized ones.
    ///
    /// Each class must take a fair share of the boxes, so that there are few classes. In a crowd, which comes from a single tube, tubes must
    /// be much less full than that. If no grid does that, there is a single tube.
    pub(super) fn assign<F>(
        &mut self,
        members: impl Members,
        assignment: &mut Assignment,
        run: &mut Run<R, D, F>,
    ) -> Result<(), FoundInvalid> {
        let count = members.count();
        let sizes = match count {
            ..=ONE_TUBE_UP_TO => &[][..],
            _ if run.is_crowd => &CROWD_SIZE_QUANTILES,
            _ => &[GRID_SIZE_QUANTILE],
        };
        self.is_separated = false;
        run.stopwatch.enter(Phase::Read);
        for &size in sizes {
            self.grid = Grid::choose(run.boxes, members, size, run.is_crowd);
            self.count(members, assignment, run)?;
            let taken = count - self.oversized.len();
            self.is_separated = taken > count / 8
                && (!run.is_crowd || assignment.comparisons() <= taken as u64 * taken as u64 / 4);
            if self.is_separated {
                break;
            }
        }
        if !self.is_separated {
            self.grid = Grid::of_one_tube(run.boxes, members);
            self.count(members, assignment, run)?;
        }
        run.stopwatch.enter(Phase::Sort);
        assignment.place(members, run.section);
        run.stopwatch.leave();
        Ok(())
    }

    /// Counts the entries of each tube, and takes the oversized boxes.
    fn count<F>(
        &mut self,
        members: impl Members,
        assignment: &mut Assignment,
        run: &Run<R, D, F>,
    ) -> Result<(), FoundInvalid> {
        assignment.count(members, &self.grid, run);
        self.oversized.clear();
        for part in &mut assignment.parts {
            if part.is_invalid {
                return Err(FoundInvalid);
            }
            self.oversized.append(&mut part.oversized);
        }
        Ok(())
    }

    /// Sorts and sweeps the tubes, and appends the pairs. The tubes stay if the run asks for it, or if it has several
    /// classes.
    pub(super) fn sweep<F: Fn([u32; 2]) -> bool + Sync>(
        &mut self,
        assignment: &Assignment,
        is_first: bool,
        run: &mut Run<R, D, F>,
    ) {
        let (boxes, slabs) = (run.boxes, &mut self.slabs);
        let may_crowd = self.is_separated || !run.is_crowd;
        let keeps = run.keeps || !is_first || !self.oversized.is_empty();
        let ranges = assignment.split();
        slabs.resize_with(ranges.len(), Slab::default);
        for (slab, range) in slabs.iter_mut().zip(ranges) {
            slab.tubes.clear(range);
            slab.stopwatch = run.stopwatch.reset();
        }
        // The first one need not copy its pairs.
        std::mem::swap(&mut slabs[0].pairs, run.pairs);
        let (wanted, most) = (run.wanted.as_ref(), run.room());
        run.section.for_each(slabs, |slab| {
            let first = slab.pairs.len();
            slab.sweep(boxes, assignment, may_crowd, keeps, most);
            slab.tally.unwanted = drop_unwanted(&mut slab.pairs, first, wanted);
        });
        std::mem::swap(&mut slabs[0].pairs, run.pairs);
        for slab in &mut slabs[1..] {
            run.pairs.append(&mut slab.pairs);
        }
        slabs.iter().for_each(|slab| run.tally += slab.tally);
        // They have worked at the same time.
        for slab in &*slabs {
            let PhaseTimes { sort, sweep, .. } = slab.stopwatch.times;
            run.stopwatch.times.sort += sort / slabs.len() as u32;
            run.stopwatch.times.sweep += sweep / slabs.len() as u32;
        }
    }

    /// Replaces `members` by the boxes of the class, in the order of its tubes.
    pub(super) fn list_members(&self, members: &mut Vec<u32>) {
        members.clear();
        let entries = self.slabs.iter().flat_map(|slab| slab.tubes.entries());
        let at_home = entries.filter(|owner| owner.is_at_home());
        members.extend(at_home.map(|owner| owner.index()));
    }

    /// How much it takes to look these boxes up in the class, by a sample of them.
    pub(super) fn effort(&self, queries: &[u32], boxes: &[Aabb<R, D>]) -> f64 {
        let (mut pairs, mut count) = (Vec::new(), 0);
        let mut emitter = Emitter::new(&mut pairs, 0);
        for i in sample_indices(queries.len(), EFFORT_SAMPLE) {
            let query = queries[i];
            self.look_up(&boxes[query as usize], query, &mut emitter);
            count += 1;
        }
        let compared = emitter.finish().compared as f64 / f64::from(count.max(1));
        (QUERY + compared) * queries.len() as f64
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
        let (wanted, most) = (run.wanted.as_ref(), run.room());
        run.tally += look_up_in_parts(queries, run.pairs, wanted, most, |i, emitter| {
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
            let bounds = self.slabs.iter().filter_map(|slab| slab.tubes.bounds);
            let bounds = bounds.reduce(|all, bounds| all.around(&bounds));
            self.bounds = bounds.map(|bounds| {
                let span = self.grid.tube_span(&bounds);
                (bounds, self.grid.tells_apart(&span).then_some(span.first))
            });
        }
    }

    /// Emits the pair of a box with every box of the class that it overlaps.
    pub(super) fn look_up(&self, aabb: &Aabb<R, D>, index: u32, emitter: &mut Emitter) {
        let (grid, slabs) = (&self.grid, &self.slabs);
        // Beyond all boxes, tubes share their numbers with others.
        let near = self
            .bounds
            .and_then(|(bounds, first)| Some((aabb.within(&bounds)?, first)));
        let Some((near, first)) = near else {
            return;
        };
        let span = grid.tube_span(&near);
        let query = Query {
            aabb,
            index,
            grid,
            first,
            span,
        };
        if span.count() > self.tube_count() as u64 {
            for slab in slabs {
                slab.tubes.look_up_everywhere(&query, emitter);
            }
            return;
        }
        // Of this order, however many slabs there are.
        let TubeSpan { first, last } = span;
        for row in first[0]..=last[0] {
            for column in first[1]..=last[1] {
                let (tube, strips) = (grid.tube([row, column]), [row, column]);
                let slab = slabs.partition_point(|slab| slab.tubes.range.end <= tube);
                slabs[slab].tubes.look_up(tube, strips, &query, emitter);
            }
        }
    }

    /// How many tubes have entries.
    fn tube_count(&self) -> usize {
        self.slabs.iter().map(|slab| slab.tubes.tubes.len()).sum()
    }
}

/// Appends what is found for each query, if it is wanted, in the order of the queries, by several threads if they are many. Stops when
/// there are more than `most` pairs.
pub(super) fn look_up_in_parts(
    queries: &[u32],
    pairs: &mut Vec<[u32; 2]>,
    wanted: Option<&(impl Fn([u32; 2]) -> bool + Sync)>,
    most: usize,
    look_up: impl Fn(u32, &mut Emitter) + Sync,
) -> Tally {
    let section = Section::of(queries.len(), LOOKED_UP);
    let queries_a_part = queries.len().div_ceil(section.parts()).max(1);
    let parts = queries.chunks(queries_a_part);
    let parts = parts.map(|queries| (queries, Vec::new(), Tally::default()));
    let mut parts: Vec<_> = parts.collect();
    if let [(_, found, _), ..] = &mut parts[..] {
        // The first one need not copy its pairs.
        std::mem::swap(found, pairs);
    }
    section.for_each(&mut parts, |(queries, found, tally)| {
        let first = found.len();
        let mut emitter = Emitter::new(found, most);
        for &i in *queries {
            look_up(i, &mut emitter);
            if emitter.is_over() {
                break;
            }
        }
        *tally = emitter.finish();
        tally.unwanted = drop_unwanted(found, first, wanted);
    });
    let mut all = Tally::default();
    parts.iter().for_each(|(_, _, tally)| all += *tally);
    let mut parts = parts.into_iter().map(|(_, found, _)| found);
    if let Some(first) = parts.next() {
        *pairs = first;
    }
    parts.for_each(|found| pairs.extend(found));
    all
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
