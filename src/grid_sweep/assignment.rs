//! Which boxes of a class are in which tube.
//!
//! Threads divide the boxes among them, not the tubes, so that one thread reads each box. Within a part of the boxes this is a counting
//! sort: boxes are counted by tube, then placed. The entries of a tube are gathered from the parts when the tube is swept.

use std::ops::Range;

use super::choose::{overlaps_and_pairs, sample_of};
use super::entry::{Entry, MAX_ENTRIES, Owner, Placed};
use super::grid::Grid;
use crate::aabb::Aabb;
use crate::counting_sort::{starts_from_counts, take_place};
use crate::parallel::{Section, start_of_part};
use crate::real::Real;
use crate::tuning::kernel::{
    BOXES_A_SLAB, COMPARED_A_PAIR, COMPARED_AN_ENTRY, CROWD_FROM, EFFORT_SAMPLE, NO_CROWD_UP_TO,
    SLABS_UP_TO, TABLED_TUBES_A_BOX,
};
use crate::tuning::prices::SEARCHED;

/// Scratch memory: the entries of each tube.
#[derive(Clone, Debug, Default)]
pub(super) struct Assignment {
    /// How many slabs the user asks for; `None` means as many as the work is worth.
    pub(super) slabs_asked: Option<usize>,
    pub(super) parts: Vec<Part>,
    /// At most so many slabs.
    slab_count: usize,
    /// By tube, and for the end: how many entries the tubes before it have.
    pub(super) starts: Vec<u32>,
}

impl Assignment {
    /// Places the members in their tubes, and replaces `oversized` by those that are invalid or too large for the grid.
    pub(super) fn assign<R: Real, const D: usize>(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: &[u32],
        grid: &Grid<R>,
        oversized: &mut Vec<u32>,
    ) {
        let (count, tubes) = (members.len(), grid.tube_count());
        let section = Section::of(count, SEARCHED);
        // Both limits keep memory proportional to the boxes, whatever the user asks for.
        let asked = self.slabs_asked.unwrap_or(section.parts());
        self.slab_count = asked.min(SLABS_UP_TO + count / BOXES_A_SLAB);
        let tabled = TABLED_TUBES_A_BOX * count as u64 / u64::from(tubes);
        let part_count = self.slab_count.min(tabled.min(count as u64) as usize);
        let parts = members.chunks(count.div_ceil(part_count.max(1)).max(1));
        self.parts.resize_with(parts.len(), Part::default);
        let mut parts: Vec<_> = self.parts.iter_mut().zip(parts).collect();
        section.for_each(&mut parts, |(part, own)| part.assign(boxes, own, grid));
        oversized.clear();
        for part in &mut self.parts {
            oversized.append(&mut part.oversized);
        }
        let parts = &self.parts;
        let start = |tube: usize| parts.iter().map(|part| part.starts[tube]).sum::<u32>();
        self.starts.clear();
        self.starts.extend((0..=tubes as usize).map(start));
    }

    /// How many pairs of entries share a tube, counted twice and with each entry paired with itself.
    pub(super) fn comparisons(&self) -> u64 {
        let counts = self.starts.windows(2).map(|of| u64::from(of[1] - of[0]));
        counts.map(|count| count.pow(2)).sum()
    }

    /// Moves the boxes at home in crowded tubes from `members` to `oversized`, and returns whether there are any. Not if few would stay.
    ///
    /// A tube is crowded if it has many more entries than most, and a sample says that the sweep would exceed its budget there: boxes that
    /// are much smaller than most, say, or that lie where the sample for the grid saw nothing.
    pub(super) fn leave_crowds<R: Real, const D: usize>(
        &self,
        boxes: &[Aabb<R, D>],
        members: &mut Vec<u32>,
        oversized: &mut Vec<u32>,
    ) -> bool {
        let count = |tube: u32| self.entries_before(tube + 1) - self.entries_before(tube);
        let tubes = 0..self.starts.len() as u32 - 1;
        let occupied = tubes.clone().filter(|&tube| count(tube) > 0).count();
        let mean = self.entries_before(tubes.end) / occupied.max(1);
        let mut leaving = Vec::new();
        for tube in tubes.filter(|&tube| count(tube) > NO_CROWD_UP_TO.max(CROWD_FROM * mean)) {
            let owners = self.parts.iter().flat_map(|part| part.tube(tube));
            let at_home = owners.filter(|owner| owner.is_at_home());
            let homes: Vec<_> = at_home.map(|owner| owner.index()).collect();
            let sample = sample_of(&homes, EFFORT_SAMPLE).map(|&i| &boxes[i as usize]);
            let shares = overlaps_and_pairs(sample.collect());
            let [overlaps, pairs] = shares.map(|share| share * count(tube) as f64);
            if overlaps > COMPARED_AN_ENTRY as f64 + COMPARED_A_PAIR as f64 * pairs {
                leaving.extend(homes);
            }
        }
        let gone = oversized.len() + leaving.len();
        if leaving.is_empty() || members.len() - gone < members.len() / 8 {
            return false;
        }
        oversized.extend(leaving);
        let mut stays = vec![true; boxes.len()];
        oversized.iter().for_each(|&i| stays[i as usize] = false);
        members.retain(|&i| stays[i as usize]);
        true
    }

    /// How many entries the tubes before this one have.
    pub(super) fn entries_before(&self, tube: u32) -> usize {
        self.starts[tube as usize] as usize
    }

    /// Divides the tubes into ranges with about as many entries each.
    pub(super) fn split(&self) -> Vec<Range<u32>> {
        let tubes = self.starts.len() as u32 - 1;
        let total = self.entries_before(tubes);
        let cut = |i: usize| {
            let before = start_of_part(i, self.slab_count, total) as u32;
            self.starts.partition_point(|&start| start < before) as u32
        };
        let cuts = (0..self.slab_count).map(cut).chain([tubes]);
        let mut cuts: Vec<_> = cuts.collect();
        cuts.dedup();
        cuts.windows(2).map(|cuts| cuts[0]..cuts[1]).collect()
    }

    /// Appends the entries of a tube, in the order of the members.
    #[inline]
    pub(super) fn gather<R: Real, const D: usize>(
        &self,
        boxes: &[Aabb<R, D>],
        tube: u32,
        entries: &mut Vec<Entry<R, D>>,
    ) {
        // Boxes are anywhere in memory. They are copied before they are sorted, so that no read has to wait for another.
        for part in &self.parts {
            entries.extend(part.tube(tube).iter().map(|&owner| Entry {
                aabb: boxes[owner.index() as usize],
                owner,
            }));
        }
    }
}

/// Members whose entries are written to the stack before they are appended.
const BATCH: usize = 64;

/// The entries of a part of the members, by tube, in the order of the members.
///
/// An entry is only its owner here. Writing boxes to hundreds of places takes longer than reading them again, tube by tube: those
/// reads do not wait for each other.
#[derive(Clone, Debug, Default)]
pub(super) struct Part {
    /// The boxes that are invalid or too large for the grid.
    oversized: Vec<u32>,
    /// Scratch: the entries in the order of the members.
    placed: Vec<Placed>,
    /// By tube, and for the end: where its entries start in `owners`.
    starts: Vec<u32>,
    /// The owners of the entries, tube after tube; what follows them is unspecified.
    owners: Vec<Owner>,
}

impl Part {
    /// Finds the tubes of the boxes with these indices.
    fn assign<R: Real, const D: usize>(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: &[u32],
        grid: &Grid<R>,
    ) {
        let (oversized, placed) = (&mut self.oversized, &mut self.placed);
        oversized.clear();
        placed.clear();
        // The number of entries, one place further on; then the place of the next one, and in the end the start of the next tube.
        self.starts.clear();
        self.starts.resize(grid.tube_count() as usize + 1, 0);
        let next = &mut self.starts[1..];
        let mut batch = [Placed::default(); MAX_ENTRIES * BATCH];
        for members in members.chunks(BATCH) {
            let mut count = 0;
            for &index in members {
                let aabb = &boxes[index as usize];
                let span = grid.tube_span(aabb);
                if grid.is_oversized(aabb, &span) | !aabb.is_valid() {
                    oversized.push(index);
                    continue;
                }
                // Whether a box has a ghost is practically random, so there is no branch on it.
                let list = batch[count..].first_chunk_mut().expect("there is room");
                count += grid.write_entries::<D>(index, &span, list);
            }
            let batch = &batch[..count];
            for entry in batch {
                next[entry.tube as usize] += 1;
            }
            placed.extend_from_slice(batch);
        }
        starts_from_counts(next);
        // Every owner that is read later is written below, so old ones need not be cleared.
        if self.owners.len() < placed.len() {
            self.owners.resize(placed.len(), Owner::default());
        }
        let owners = &mut self.owners[..];
        for entry in &*placed {
            owners[take_place(next, entry.tube as usize)] = entry.owner;
        }
    }

    /// The owners of a tube's entries.
    #[inline]
    fn tube(&self, tube: u32) -> &[Owner] {
        let [start, end] = [tube, tube + 1].map(|tube| self.starts[tube as usize] as usize);
        &self.owners[start..end]
    }
}
