//! A range of tubes, sorted and swept by one thread.
//!
//! Tubes do not depend on each other. So the slabs find, one after the other, the pairs of a single slab in the same order.
//!
//! A box has an *entry* in each tube that it reaches: its own one in the tube of its `mins`, and a *ghost* in each of the others. Entries
//! are a structure of arrays, so that eight of them are compared at once. After each tube there is a sentinel whose `mins[0]` is NaN, at
//! which every window ends. Unless boxes will be looked up, each tube overwrites the last one, so that the arrays stay in the cache.

use std::ops::Range;

use super::assignment::Assignment;
use super::entry::{Entry, Owner};
use super::grid::{Grid, REACH};
use super::segment_tree::match_all;
use super::worker::Worker;
use crate::aabb::{Aabb, max, min};
use crate::bucket_sort::BucketSort;
use crate::lanes::LANES;
use crate::real::Real;
use crate::tuning::kernel::{COMPARED_AN_ENTRY, NO_CROWD_UP_TO};

/// More entries than are read past the last sentinel: eight are compared with up to five times as many that follow.
const PADDING: usize = LANES + 64;

/// A tube that has entries, kept for look-ups.
#[derive(Clone, Debug)]
pub(super) struct Tube<R, const D: usize> {
    /// Its entries, after which there is the sentinel.
    pub(super) entries: Range<usize>,
    /// A box around its boxes.
    pub(super) bounds: Aabb<R, D>,
    /// Its strips, if it holds the entries of a single tube and not of several that share a number.
    pub(super) strips: Option<[u32; 2]>,
}

/// Some of the tubes of a grid.
#[derive(Clone, Debug)]
pub(super) struct Slab<R, const D: usize> {
    /// The numbers of the tubes.
    pub(super) range: Range<u32>,
    /// The tubes that are kept, by number.
    pub(super) tubes: Vec<Tube<R, D>>,
    /// For each tube of the range its position in `tubes`, or `u32::MAX`.
    pub(super) table: Vec<u32>,
    pub(super) mins: [Vec<R>; D],
    pub(super) maxs: [Vec<R>; D],
    pub(super) owners: Vec<Owner>,
    /// By entry that is kept, the greatest `maxs[0]` up to it in its tube.
    pub(super) running_maxs: Vec<R>,
    /// Scratch: the entries of one tube, and their order.
    pub(super) entries: Vec<Entry<R, D>>,
    pub(super) sorter: BucketSort<R>,
}

impl<R: Real, const D: usize> Default for Slab<R, D> {
    fn default() -> Self {
        Self {
            range: 0..0,
            tubes: Vec::new(),
            table: Vec::new(),
            mins: core::array::from_fn(|_| Vec::new()),
            maxs: core::array::from_fn(|_| Vec::new()),
            owners: Vec::new(),
            running_maxs: Vec::new(),
            entries: Vec::new(),
            sorter: BucketSort::default(),
        }
    }
}

impl<R: Real, const D: usize> Slab<R, D> {
    /// Gathers each tube of the range, then sorts and sweeps it while it is in the cache. Keeps it if there is a grid.
    ///
    /// If the sweep takes many comparisons for each entry, and some for each pair, a segment tree finds the pairs. Stops early if more
    /// pairs overlap than may be appended.
    pub(super) fn sweep(
        &mut self,
        boxes: &[Aabb<R, D>],
        assignment: &Assignment,
        grid: Option<&Grid<R>>,
        worker: &mut Worker,
    ) {
        self.tubes.clear();
        self.table.clear();
        let range = self.range.clone();
        if grid.is_some() {
            self.table.resize(range.len(), u32::MAX);
            let [start, end] = [range.start, range.end].map(|tube| assignment.entries_before(tube));
            self.make_room(end - start + range.len() + PADDING);
            self.running_maxs.resize(end - start + range.len(), R::NAN);
        }
        let mut entries = std::mem::take(&mut self.entries);
        for tube in range {
            entries.clear();
            assignment.gather(boxes, tube, &mut entries);
            if entries.is_empty() {
                continue;
            }
            let sorted = self.sort(&entries);
            if let Some(grid) = grid {
                self.keep(tube, sorted.clone(), grid);
            }
            worker.begin_task(match entries.len() {
                ..=NO_CROWD_UP_TO => u64::MAX,
                many => COMPARED_AN_ENTRY * many as u64,
            });
            let is_swept = self.columns().sweep(sorted, worker);
            if worker.is_over() {
                break;
            }
            if !is_swept {
                worker.take_back();
                match_all(&mut entries, worker);
            }
        }
        self.entries = entries;
    }

    /// Keeps a sorted tube for look-ups.
    #[inline(never)]
    fn keep(&mut self, number: u32, entries: Range<usize>, grid: &Grid<R>) {
        let mins = self.mins.each_ref().map(|column| &column[entries.clone()]);
        let maxs = self.maxs.each_ref().map(|column| &column[entries.clone()]);
        let mut bounds = Aabb::EMPTY;
        for (i, running_max) in self.running_maxs[entries.clone()].iter_mut().enumerate() {
            for k in 0..D {
                bounds.mins[k] = min(mins[k][i], bounds.mins[k]);
                bounds.maxs[k] = max(maxs[k][i], bounds.maxs[k]);
            }
            *running_max = bounds.maxs[0];
        }
        // Tubes that share a number lie farther apart.
        let beyond = grid.tube_span(&bounds).beyond();
        let is_one = beyond.iter().all(|&beyond| u64::from(beyond) <= REACH);
        let first = Aabb::new(mins.map(|column| column[0]), maxs.map(|column| column[0]));
        let home = grid.tube_span(&first).first;
        let strips = is_one.then(|| self.owners[entries.start].strips(home));
        self.table[(number - self.range.start) as usize] = self.tubes.len() as u32;
        self.tubes.push(Tube {
            entries,
            bounds,
            strips,
        });
    }

    /// The owners of the entries that are kept, and of the sentinels in between, which are not at home.
    pub(super) fn kept_owners(&self) -> &[Owner] {
        &self.owners[..self.tubes.last().map_or(0, |tube| tube.entries.end)]
    }

    /// Makes the arrays at least this long. What follows the last sentinel is unspecified.
    fn make_room(&mut self, len: usize) {
        if self.owners.len() < len {
            for array in self.mins.iter_mut().chain(&mut self.maxs) {
                array.resize(len, R::NAN);
            }
            self.owners.resize(len, Owner::NOBODY);
        }
    }

    /// Sorts entries by `mins[0]` into the arrays after the tubes that are kept, puts a sentinel after them, and returns where they are.
    /// Inlined into the loop over tubes, it would compile to slower code.
    #[inline(never)]
    pub(super) fn sort(&mut self, entries: &[Entry<R, D>]) -> Range<usize> {
        let start = self.tubes.last().map_or(0, |tube| tube.entries.end + 1);
        let end = start + entries.len();
        self.make_room(end + 1 + PADDING);
        let (mins, maxs, owners) = (&mut self.mins, &mut self.maxs, &mut self.owners);
        let numbers = entries.iter().map(|entry| entry.aabb.mins[0]);
        let order = self.sorter.sort(numbers);
        // Slices of one length need one bounds check.
        let lows = mins.each_mut().map(|column| &mut column[start..end]);
        let highs = maxs.each_mut().map(|column| &mut column[start..end]);
        let owners_here = &mut owners[start..end];
        for (position, (&(_, i), owner_here)) in order.iter().zip(owners_here).enumerate() {
            let Entry { aabb, owner } = &entries[i as usize];
            for k in 0..D {
                lows[k][position] = aabb.mins[k];
                highs[k][position] = aabb.maxs[k];
            }
            *owner_here = *owner;
        }
        for column in mins.iter_mut().chain(maxs.iter_mut()) {
            column[end] = R::NAN;
        }
        owners[end] = Owner::NOBODY;
        start..end
    }
}
