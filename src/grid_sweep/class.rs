//! One size class: its boxes are assigned to the tubes of a grid, and each tube is sorted and swept.

use super::emitter::Emitter;
use super::grid::Grid;
use super::lookup::Query;
use super::members::Members;
use super::part::{Part, Parts};
use super::scattered::Scattered;
use super::slab::Slab;
use crate::aabb::Aabb;
use crate::parallel;
use crate::real::Real;
use crate::stopwatch::{Phase, PhaseTimes, Stopwatch};
use crate::tuning::kernel::{ONE_TUBE_UP_TO, OVERSIZED_UP_TO_EIGHTHS, STRIP_WIDENINGS};

/// What a run of the kernel works with, in every class.
pub(super) struct Run<'a, R, const D: usize> {
    pub(super) boxes: &'a [Aabb<R, D>],
    /// How many slabs the work is cut into, at most.
    pub(super) slab_count: usize,
    /// Whether boxes will be looked up when the run is over.
    pub(super) keeps: bool,
    pub(super) pairs: &'a mut Vec<[u32; 2]>,
    pub(super) stopwatch: &'a mut Stopwatch,
}

/// A box is invalid: what has been found is unspecified.
pub(super) struct FoundInvalid;

/// Scratch memory: which boxes of a class are in which tube.
#[derive(Clone, Debug, Default)]
pub(super) struct Assignment {
    /// By tubes, of which there is a table: a part for each thread.
    parts: Vec<Part>,
    /// Where there are too many tubes for a table, the boxes sorted by tubes instead.
    scattered: Scattered,
    is_scattered: bool,
}

/// The boxes of one size class, sorted into tubes.
#[derive(Clone, Debug, Default)]
pub(super) struct Class<R, const D: usize> {
    pub(super) grid: Grid<R>,
    /// Together they cover the grid.
    slabs: Vec<Slab<R, D>>,
    /// The boxes too large for this class: the members of all following classes.
    pub(super) oversized: Vec<u32>,
}

impl<R: Real, const D: usize> Class<R, D> {
    /// Chooses a grid and assigns the members to its tubes, except the oversized ones.
    ///
    /// Each class must take a fair share of the boxes, so that there are few classes. If a grid turns out to be too
    /// fine for that, wider ones are tried, and in the end a single tube, for which nothing is oversized.
    pub(super) fn assign(
        &mut self,
        members: impl Members,
        assignment: &mut Assignment,
        run: &mut Run<R, D>,
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
            self.oversized.clear();
            assignment.is_scattered = !self.grid.fits_table(count);
            match assignment.is_scattered {
                true => self.scatter(members, &mut assignment.scattered, run)?,
                false => self.count_by_tube(members, &mut assignment.parts, run)?,
            }
            if self.oversized.len() <= count / 8 * OVERSIZED_UP_TO_EIGHTHS {
                break;
            }
        }
        run.stopwatch.enter(Phase::Sort);
        if !assignment.is_scattered {
            parallel::for_each(&mut assignment.parts, |part| part.place(members));
        }
        run.stopwatch.leave();
        Ok(())
    }

    /// Shares the members out to the parts, and counts the entries of each tube.
    fn count_by_tube(
        &mut self,
        members: impl Members,
        parts: &mut Vec<Part>,
        run: &Run<R, D>,
    ) -> Result<(), FoundInvalid> {
        let count = members.count();
        let part_count = run.slab_count.min(count).max(1);
        parts.resize_with(part_count, Part::default);
        for (i, part) in parts.iter_mut().enumerate() {
            part.range = i * count / part_count..(i + 1) * count / part_count;
        }
        parallel::for_each(parts, |part| part.count(run.boxes, members, &self.grid));
        for part in parts {
            if part.is_invalid {
                return Err(FoundInvalid);
            }
            self.oversized.append(&mut part.oversized);
        }
        Ok(())
    }

    /// Sorts the members by tubes.
    fn scatter<M: Members>(
        &mut self,
        members: M,
        scattered: &mut Scattered,
        run: &mut Run<R, D>,
    ) -> Result<(), FoundInvalid> {
        let mut are_valid = true;
        if M::MAY_BE_INVALID {
            members.for_each(run.boxes, 0..members.count(), |_, _, aabb| {
                are_valid &= aabb.is_valid();
            });
        }
        if !are_valid {
            return Err(FoundInvalid);
        }
        run.stopwatch.enter(Phase::Sort);
        self.grid.extend::<D>();
        scattered.assign(run.boxes, members, &self.grid, &mut self.oversized);
        Ok(())
    }

    /// Sorts and sweeps the tubes, and appends the pairs. The tubes stay if the run asks for it, or there are oversized boxes to
    /// look up in them.
    pub(super) fn sweep(&mut self, assignment: &Assignment, run: &mut Run<R, D>) {
        let Run {
            boxes,
            ref mut pairs,
            ..
        } = *run;
        let keeps = run.keeps || !self.oversized.is_empty();
        let parts = Parts {
            parts: &assignment.parts,
            tubes: self.grid.tube_count() as u32,
            columns: self.grid.columns(),
        };
        let ranges = match assignment.is_scattered {
            true => std::iter::once(0..0).collect(),
            false => parts.split(run.slab_count),
        };
        self.slabs.resize_with(ranges.len(), Slab::default);
        for (slab, range) in self.slabs.iter_mut().zip(ranges) {
            slab.tubes.clear(range);
            slab.stopwatch = run.stopwatch.reset();
        }
        match &mut self.slabs[..] {
            [slab] if assignment.is_scattered => {
                slab.sweep_scattered(boxes, &assignment.scattered, keeps, pairs);
            }
            [slab] => slab.sweep_parts(boxes, parts, keeps, pairs),
            slabs => {
                // The first one need not copy its pairs.
                std::mem::swap(&mut slabs[0].pairs, pairs);
                parallel::for_each(slabs, |slab| {
                    let mut pairs = std::mem::take(&mut slab.pairs);
                    slab.sweep_parts(boxes, parts, keeps, &mut pairs);
                    slab.pairs = pairs;
                });
                std::mem::swap(&mut slabs[0].pairs, pairs);
                for slab in &mut slabs[1..] {
                    pairs.append(&mut slab.pairs);
                }
            }
        }
        // They have worked at the same time.
        for slab in &self.slabs {
            let PhaseTimes { sort, sweep, .. } = slab.stopwatch.times;
            run.stopwatch.times.sort += sort / self.slabs.len() as u32;
            run.stopwatch.times.sweep += sweep / self.slabs.len() as u32;
        }
    }

    /// Appends the pairs of the oversized boxes with those of the class.
    pub(super) fn look_up_oversized(&mut self, run: &mut Run<R, D>) {
        if self.oversized.is_empty() {
            return;
        }
        run.stopwatch.enter(Phase::Sweep);
        self.prepare_lookup();
        let mut emitter = Emitter::new(run.pairs);
        for &i in &self.oversized {
            self.look_up(&run.boxes[i as usize], i, &mut emitter);
        }
        emitter.finish();
        run.stopwatch.leave();
    }

    /// Prepares for [`look_up`](Self::look_up), until the next run.
    pub(super) fn prepare_lookup(&mut self) {
        if self.slabs.iter().all(|slab| slab.tubes.is_prepared()) {
            return;
        }
        let columns = self.grid.columns();
        parallel::for_each(&mut self.slabs, |slab| slab.tubes.prepare_lookup(columns));
    }

    /// Emits the pair of a box with every box of the class that it overlaps.
    pub(super) fn look_up(&self, aabb: &Aabb<R, D>, index: u32, emitter: &mut Emitter) {
        let span = self.grid.tube_span(aabb);
        let query = Query { aabb, index, span };
        for slab in &self.slabs {
            slab.tubes.look_up(&query, self.grid.columns(), emitter);
        }
    }

    /// Frees what only a run needs.
    pub(super) fn free_scratch(&mut self) {
        self.slabs.iter_mut().for_each(Slab::free_scratch);
    }
}
