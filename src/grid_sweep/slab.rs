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
use super::search::Found;
use super::segment_tree::match_all;
use super::worker::Worker;
use crate::aabb::Aabb;
use crate::bucket_sort::BucketSort;
use crate::lanes::LANES;
use crate::real::Real;
use crate::tuning::kernel::{COMPARED_AN_ENTRY, NO_CROWD_UP_TO};

/// How many entries past the last sentinel may be read: the sweep reads 64 past the last of eight.
const PADDING: usize = LANES + 64;

/// A tube that has entries.
#[derive(Clone, Debug)]
pub(super) struct Tube<R> {
    pub(super) number: u32,
    /// Its entries are `start..end`, and the sentinel is at `end`.
    pub(super) start: u32,
    pub(super) end: u32,
    /// The interval of its boxes along the first axis; for look-ups.
    pub(super) reach: [R; 2],
    /// Its strips, if it holds the entries of a single tube and not of several that share a number; for look-ups.
    pub(super) strips: Option<[u32; 2]>,
}

/// Some of the tubes of a grid.
#[derive(Clone, Debug)]
pub(super) struct Slab<R, const D: usize> {
    /// The numbers of the tubes.
    pub(super) range: Range<u32>,
    /// Whether tubes are kept.
    keeps: bool,
    /// The tubes that are kept, by number.
    pub(super) tubes: Vec<Tube<R>>,
    /// For each tube of the range its position in `tubes`, or [`NOWHERE`]; empty until look-ups are prepared.
    pub(super) table: Vec<u32>,
    pub(super) mins: [Vec<R>; D],
    pub(super) maxs: [Vec<R>; D],
    pub(super) owners: Vec<Owner>,
    /// By entry, the greatest `maxs[0]` up to it in its tube; for look-ups.
    pub(super) running_maxs: Vec<R>,
    /// A box around all entries; for look-ups.
    pub(super) bounds: Aabb<R, D>,
    /// Scratch: the entries of one tube, their order, and the pairs.
    entries: Vec<Entry<R, D>>,
    sorter: BucketSort<R>,
    pub(super) found: Found,
}

/// The position of a tube without entries.
pub(super) const NOWHERE: u32 = u32::MAX;

impl<R: Real, const D: usize> Default for Slab<R, D> {
    fn default() -> Self {
        Self {
            range: 0..0,
            keeps: false,
            tubes: Vec::new(),
            table: Vec::new(),
            mins: core::array::from_fn(|_| Vec::new()),
            maxs: core::array::from_fn(|_| Vec::new()),
            owners: Vec::new(),
            running_maxs: Vec::new(),
            bounds: Aabb::EMPTY,
            entries: Vec::new(),
            sorter: BucketSort::default(),
            found: Found::default(),
        }
    }
}

impl<R: Real, const D: usize> Slab<R, D> {
    /// Removes all tubes. Those to come have numbers of this range.
    pub(super) fn reset(&mut self, range: Range<u32>, keeps: bool) {
        (self.range, self.keeps) = (range, keeps);
        self.tubes.clear();
        self.table.clear();
    }

    /// Frees the memory that only a search needs.
    pub(super) fn free_scratch(&mut self) {
        self.entries = Vec::new();
        self.sorter = BucketSort::default();
        self.found = Found::default();
    }

    /// Gathers each tube of the range, then sorts and sweeps it while it is in the cache.
    ///
    /// If the sweep takes many comparisons for each entry, and some for each pair, a segment tree finds the pairs. Stops early if more
    /// pairs overlap than may be appended.
    pub(super) fn sweep(
        &mut self,
        boxes: &[Aabb<R, D>],
        assignment: &Assignment,
        worker: &mut Worker,
    ) {
        let range = self.range.clone();
        if self.keeps {
            let before = |tube| assignment.entries_before(tube);
            let is_occupied = |tube: &u32| before(*tube) < before(tube + 1);
            let tubes = range.clone().filter(is_occupied).count();
            self.make_room(before(range.end) - before(range.start) + tubes + PADDING);
            self.tubes.reserve(tubes);
        }
        let mut entries = std::mem::take(&mut self.entries);
        for tube in range {
            entries.clear();
            assignment.gather(boxes, tube, &mut entries);
            if entries.is_empty() {
                continue;
            }
            let sorted = self.push(tube, &entries);
            worker.begin_task(match entries.len() {
                ..=NO_CROWD_UP_TO => usize::MAX,
                many => COMPARED_AN_ENTRY.saturating_mul(many),
            });
            let is_swept = self.columns().sweep(sorted, worker);
            if worker.pairs.is_over() {
                break;
            }
            if !is_swept {
                worker.take_back();
                match_all(&mut entries, worker);
            }
        }
        self.entries = entries;
    }

    /// Adds the next tube that has entries, and returns where they are. Inlined into the loop over tubes, it would compile to slower code.
    #[inline(never)]
    pub(super) fn push(&mut self, number: u32, entries: &[Entry<R, D>]) -> Range<usize> {
        let start = self.tubes.last().map_or(0, |tube| tube.end as usize + 1);
        let end = start + entries.len();
        self.make_room(end + 1 + PADDING);
        self.sort(start, entries);
        if self.keeps {
            self.tubes.push(Tube {
                number,
                start: start as u32,
                end: end as u32,
                reach: [R::ZERO; 2],
                strips: None,
            });
        }
        start..end
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

    /// Sorts entries by `mins[0]` into the arrays, and puts a sentinel after them.
    fn sort(&mut self, start: usize, entries: &[Entry<R, D>]) {
        let (mins, maxs, owners) = (&mut self.mins, &mut self.maxs, &mut self.owners);
        let order = self
            .sorter
            .sort(entries.iter().map(|entry| entry.aabb.mins[0]));
        let end = start + entries.len();
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
    }
}
