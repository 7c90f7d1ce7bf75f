//! Which boxes of a class are in which tube.

use std::ops::Range;

use super::class::Run;
use super::grid::Grid;
use super::members::Members;
use super::part::Part;
use crate::parallel::{Section, start_of_part};
use crate::real::Real;
use crate::tuning::kernel::{BOXES_A_SLAB, SLABS_UP_TO, TABLED_TUBES_A_BOX};

/// Scratch memory: the entries of each tube. The members are [counted](Self::count), then [placed](Self::place).
#[derive(Clone, Debug, Default)]
pub(super) struct Assignment {
    /// One for each thread.
    pub(super) parts: Vec<Part>,
    /// How many slabs the tubes are cut into, at most.
    slab_count: usize,
    /// How many tubes have a number.
    tubes: u32,
}

impl Assignment {
    /// Shares the members out to the parts, and finds their tubes, the oversized, and whether there are invalid ones.
    pub(super) fn count<R: Real, const D: usize, F>(
        &mut self,
        members: impl Members,
        grid: &Grid<R>,
        run: &Run<R, D, F>,
    ) {
        let count = members.count();
        self.tubes = grid.tube_count();
        // So that memory grows with the boxes alone, whatever was asked for.
        self.slab_count = run.slab_count.unwrap_or(run.section.parts());
        self.slab_count = self.slab_count.min(SLABS_UP_TO + count / BOXES_A_SLAB);
        let tabled = TABLED_TUBES_A_BOX * count as u64 / u64::from(self.tubes);
        let most = count.min(usize::try_from(tabled).unwrap_or(usize::MAX));
        let part_count = self.slab_count.min(most).max(1);
        self.parts.resize_with(part_count, Part::default);
        for (i, part) in self.parts.iter_mut().enumerate() {
            let [start, end] = [i, i + 1].map(|i| start_of_part(i, part_count, count));
            part.range = start..end;
        }
        let (boxes, parts) = (run.boxes, &mut self.parts);
        run.section
            .for_each(parts, |part| part.count(boxes, members, grid));
    }

    /// Places the entries of the members that were counted.
    pub(super) fn place(&mut self, members: impl Members, section: Section) {
        section.for_each(&mut self.parts, |part| part.place(members));
    }

    /// How many pairs of entries share a tube, once they are counted and before they are placed; each entry makes one with itself, and each
    /// pair counts twice.
    pub(super) fn comparisons(&self) -> u64 {
        let count = |tube: u32| {
            self.parts
                .iter()
                .map(|part| u64::from(part.ends[tube as usize]))
                .sum::<u64>()
        };
        (0..self.tubes).map(|tube| count(tube) * count(tube)).sum()
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

    /// Cuts the tubes into ranges that are about equally full.
    pub(super) fn split(&self) -> Vec<Range<u32>> {
        let count = self.slab_count;
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
