//! Which boxes of a class are in which tube.
//!
//! Where there are few tubes, each has a number, and threads count its entries and place them. Where boxes are *scattered*, so far
//! apart that a table of tubes would be mostly empty, entries are sorted by their tubes, and only tubes that have any are numbered.

use std::ops::Range;

use super::class::Run;
use super::grid::Grid;
use super::members::Members;
use super::owner::Owner;
use super::part::Part;
use crate::parallel::{Section, start_of_part};
use crate::radix_sort::RadixSort;
use crate::real::Real;
use crate::tuning::kernel::{BOXES_A_SLAB, SLABS_UP_TO, TABLED_TUBES_A_BOX};

/// Scratch memory: the entries of each tube. The members are [counted](Self::count), then [placed](Self::place).
#[derive(Clone, Debug, Default)]
pub(super) struct Assignment {
    /// One for each thread; only one if boxes are scattered.
    pub(super) parts: Vec<Part>,
    /// How many slabs the tubes are cut into, at most.
    slab_count: usize,
    /// How many tubes have a number.
    tubes: u32,
    /// How many tubes are in a row; 0 if boxes are scattered.
    pub(super) columns: u32,
    /// If boxes are scattered: the entries, each with the strips of its tube; by tube, its row above its column; and the
    /// strips of each tube.
    unsorted: Vec<([u32; 2], Owner)>,
    sorted: Vec<(u64, u32)>,
    strips: Vec<[u32; 2]>,
}

impl Assignment {
    /// Shares the members out to the parts, and finds their tubes, the oversized, and whether there are invalid ones. If boxes are
    /// scattered, the grid is extended.
    pub(super) fn count<R: Real, const D: usize, F>(
        &mut self,
        members: impl Members,
        grid: &mut Grid<R>,
        run: &Run<R, D, F>,
    ) {
        let count = members.count();
        let is_scattered = !grid.fits_table(count);
        // So that memory grows with the boxes alone, whatever was asked for.
        self.slab_count = run.slab_count.unwrap_or(run.section.parts());
        self.slab_count = self.slab_count.min(SLABS_UP_TO + count / BOXES_A_SLAB);
        let part_count = match is_scattered {
            true => 1,
            false => {
                let tabled = TABLED_TUBES_A_BOX * count as u64 / grid.tube_count();
                let most = count.min(usize::try_from(tabled).unwrap_or(usize::MAX));
                self.slab_count.min(most).max(1)
            }
        };
        self.parts.resize_with(part_count, Part::default);
        for (i, part) in self.parts.iter_mut().enumerate() {
            let [start, end] = [i, i + 1].map(|i| start_of_part(i, part_count, count));
            part.range = start..end;
        }
        if is_scattered {
            grid.extend::<D>();
            return self.scatter(members, grid, run);
        }
        (self.tubes, self.columns) = (grid.tube_count() as u32, grid.columns());
        let boxes = run.boxes;
        let parts = &mut self.parts;
        run.section
            .for_each(parts, |part| part.count(boxes, members, grid));
    }

    /// Enters the members into all tubes that they span.
    fn scatter<R: Real, M: Members, const D: usize, F>(
        &mut self,
        members: M,
        grid: &Grid<R>,
        run: &Run<R, D, F>,
    ) {
        let (part, unsorted) = (&mut self.parts[0], &mut self.unsorted);
        self.columns = 0;
        part.is_invalid = false;
        part.oversized.clear();
        *unsorted = Vec::with_capacity(members.count());
        members.for_each(run.boxes, 0..members.count(), |_, index, aabb| {
            part.is_invalid |= M::MAY_BE_INVALID && !aabb.is_valid();
            let span = grid.tube_span(aabb);
            if grid.is_oversized(aabb, &span) {
                return part.oversized.push(index);
            }
            for row in span.first[0]..=span.last[0] {
                for column in span.first[1]..=span.last[1] {
                    let owner = Owner::of(index, [row, column], span.first);
                    unsorted.push(([row, column], owner));
                }
            }
        });
    }

    /// Places the entries of the members that were counted.
    pub(super) fn place(&mut self, members: impl Members, section: Section) {
        match self.columns {
            0 => self.sort_scattered(),
            _ => section.for_each(&mut self.parts, |part| part.place(members)),
        }
    }

    /// Sorts the scattered entries by tubes, and numbers these.
    fn sort_scattered(&mut self) {
        let Self { parts, strips, .. } = self;
        let Part { ends, owners, .. } = &mut parts[0];
        // The memory of sorting is not kept: boxes are rarely scattered, and it is twice as much again.
        let unsorted = std::mem::take(&mut self.unsorted);
        let columns = unsorted
            .iter()
            .fold(0_u32, |bits, ([_, column], _)| bits | column);
        // Without a gap between row and column there are fewer digits to sort by.
        let column_bits = u32::BITS - columns.leading_zeros();
        let keyed = unsorted.iter().map(|&([row, column], owner)| {
            let tube = u64::from(row) << column_bits | u64::from(column);
            (tube, owner.0)
        });
        RadixSort::default().sort(keyed, |entry| entry, &mut self.sorted);
        strips.clear();
        ends.clear();
        owners.clear();
        for entries in self.sorted.chunk_by(|a, b| a.0 == b.0) {
            let (tube, _) = entries[0];
            let row = tube >> column_bits;
            strips.push([row as u32, (tube ^ row << column_bits) as u32]);
            owners.extend(entries.iter().map(|&(_, owner)| Owner(owner)));
            ends.push(owners.len() as u32);
        }
        self.tubes = strips.len() as u32;
    }

    /// The strips of a tube.
    pub(super) fn strips(&self, tube: u32) -> [u32; 2] {
        match self.columns {
            0 => self.strips[tube as usize],
            columns => [tube / columns, tube % columns],
        }
    }

    /// How many entries there are in the tubes before this one.
    pub(super) fn entries_before(&self, tube: u32) -> usize {
        let counts = self.parts.iter().map(|part| part.entries_before(tube));
        counts.map(|count| count as usize).sum()
    }

    /// Whether a tube has entries.
    pub(super) fn is_occupied(&self, tube: u32) -> bool {
        self.parts.iter().any(|part| !part.tube(tube).is_empty())
    }

    /// Cuts the tubes into ranges that are about equally full; scattered ones, which are searched for every box that is looked up, into
    /// one.
    pub(super) fn split(&self) -> Vec<Range<u32>> {
        let count = if self.columns == 0 {
            1
        } else {
            self.slab_count
        };
        let total = self.entries_before(self.tubes);
        let mut ranges = vec![];
        let mut start = 0;
        for cut in 1..count {
            let before = start_of_part(cut, count, total);
            let tube = self.first_with_entries_before(before).max(start + 1);
            if tube >= self.tubes {
                break;
            }
            ranges.push(start..tube);
            start = tube;
        }
        ranges.push(start..self.tubes);
        ranges
    }

    /// The first tube before which there are at least so many entries.
    fn first_with_entries_before(&self, entries: usize) -> u32 {
        let (mut low, mut high) = (0, self.tubes);
        while low < high {
            let middle = low + (high - low) / 2;
            match self.entries_before(middle) < entries {
                true => low = middle + 1,
                false => high = middle,
            }
        }
        low
    }
}
