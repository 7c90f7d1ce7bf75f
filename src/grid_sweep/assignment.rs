//! Which boxes of a class are in which tube.
//!
//! Threads divide the boxes among them, not the tubes, so that one thread reads each box. Within a part of the boxes this is a counting
//! sort: boxes are counted by tube, then placed. The entries of a tube are gathered from the parts when the tube is swept.

use std::ops::Range;

use super::choose::{overlaps_and_pairs, sample_indices};
use super::entry::{Entry, Ghost, MAX_GHOSTS, Owner};
use super::grid::Grid;
use super::search::Members;
use crate::aabb::Aabb;
use crate::counting_sort::{starts_from_counts, take_place};
use crate::invalid_input::InvalidInput;
use crate::pair_finder::check_boxes;
use crate::parallel::{Section, start_of_part};
use crate::real::Real;
use crate::tuning::kernel::{
    BOXES_A_SLAB, COMPARED_A_PAIR, COMPARED_AN_ENTRY, CROWD_FROM, EFFORT_SAMPLE, NO_CROWD_UP_TO,
    SLABS_UP_TO, TABLED_TUBES_A_BOX,
};
use crate::tuning::prices::SEARCHED;

/// Scratch memory: the entries of each tube. Members are first [counted](Self::count), then [placed](Self::place).
#[derive(Clone, Debug, Default)]
pub(super) struct Assignment {
    /// How many slabs the user asks for; `None` means as many as the work is worth.
    pub(super) slabs_asked: Option<usize>,
    pub(super) parts: Vec<Part>,
    /// The work on the members.
    pub(super) section: Section,
    /// At most so many slabs.
    slab_count: usize,
    tube_count: u32,
}

impl Assignment {
    /// Finds the tubes of the members, and replaces `oversized` by the indices of those too large for the grid.
    pub(super) fn count<R: Real, const D: usize>(
        &mut self,
        members: Members<R, D>,
        grid: &Grid<R>,
        oversized: &mut Vec<u32>,
    ) -> Result<(), InvalidInput> {
        let count = members.count();
        self.tube_count = grid.tube_count();
        self.section = Section::of(count, SEARCHED);
        // Both limits keep memory proportional to the boxes, whatever the user asks for.
        let asked = self.slabs_asked.unwrap_or(self.section.parts());
        self.slab_count = asked.min(SLABS_UP_TO + count / BOXES_A_SLAB);
        let tabled = TABLED_TUBES_A_BOX * count as u64 / u64::from(self.tube_count);
        let most = count.min(usize::try_from(tabled).unwrap_or(usize::MAX));
        let part_count = self.slab_count.min(most).max(1);
        self.parts.resize_with(part_count, Part::default);
        for (i, part) in self.parts.iter_mut().enumerate() {
            let [start, end] = [i, i + 1].map(|i| start_of_part(i, part_count, count));
            part.range = start..end;
        }
        let (section, parts) = (self.section, &mut self.parts);
        section.for_each(parts, |part| part.count(members, grid));
        oversized.clear();
        for part in parts {
            if part.is_invalid {
                check_boxes(members.boxes)?;
            }
            oversized.append(&mut part.oversized);
        }
        Ok(())
    }

    /// Places the entries of the counted members.
    pub(super) fn place<R: Real, const D: usize>(&mut self, members: Members<R, D>) {
        let parts = &mut self.parts;
        self.section.for_each(parts, |part| part.place(members));
    }

    /// How many pairs of entries share a tube, counted twice and with each entry paired with itself. Only between counting and placing.
    pub(super) fn comparisons(&self) -> u64 {
        (0..self.tube_count as usize).fold(0, |squares, tube| {
            let counts = self
                .parts
                .iter()
                .map(|part| u64::from(part.starts[tube + 1]));
            squares + counts.sum::<u64>().pow(2)
        })
    }

    /// Moves the boxes at home in crowded tubes to `oversized`, and returns the members that stay. `None` if there is no such tube, or if few
    /// would stay. Only after placing.
    ///
    /// A tube is crowded if it has many more entries than most, and a sample says that the sweep would exceed its budget there: boxes that
    /// are much smaller than most, say, or that lie where the sample for the grid saw nothing.
    pub(super) fn without_crowds<R: Real, const D: usize>(
        &self,
        members: Members<R, D>,
        oversized: &mut Vec<u32>,
    ) -> Option<Vec<u32>> {
        let count = |tube: u32| self.entries_before(tube + 1) - self.entries_before(tube);
        let tubes = 0..self.tube_count;
        let occupied = tubes.clone().filter(|&tube| count(tube) > 0).count();
        let mean = self.entries_before(self.tube_count) / occupied.max(1);
        let mut leaving = Vec::new();
        for tube in tubes.filter(|&tube| count(tube) > NO_CROWD_UP_TO.max(CROWD_FROM * mean)) {
            let owners = self.parts.iter().flat_map(|part| part.tube(tube));
            let at_home = owners.filter(|owner| owner.is_at_home());
            let mut homes = Vec::with_capacity(count(tube));
            homes.extend(at_home.map(|owner| owner.index()));
            let sample = sample_indices(homes.len(), EFFORT_SAMPLE);
            let sample = sample.map(|i| &members.boxes[homes[i] as usize]);
            let shares = overlaps_and_pairs(sample.collect());
            let [overlaps, pairs] = shares.map(|share| share * count(tube) as f64);
            if overlaps > COMPARED_AN_ENTRY as f64 + COMPARED_A_PAIR as f64 * pairs {
                leaving.extend(homes);
            }
        }
        let gone = oversized.len() + leaving.len();
        if leaving.is_empty() || members.count() - gone < members.count() / 8 {
            return None;
        }
        oversized.extend(leaving);
        let mut stays = vec![true; members.boxes.len()];
        oversized.iter().for_each(|&i| stays[i as usize] = false);
        let all = (0..members.count()).map(|i| members.index(i));
        Some(all.filter(|&i| stays[i as usize]).collect())
    }

    /// How many entries the tubes before this one have.
    pub(super) fn entries_before(&self, tube: u32) -> usize {
        let starts = self.parts.iter().map(|part| part.starts[tube as usize]);
        starts.map(|start| start as usize).sum()
    }

    /// Divides the tubes into ranges with about as many entries each.
    pub(super) fn split(&self) -> Vec<Range<u32>> {
        let total = self.entries_before(self.tube_count);
        let mut ranges = vec![];
        let mut start = 0;
        for cut in 1..self.slab_count {
            let before = start_of_part(cut, self.slab_count, total);
            // A binary search for the first tube with that many entries before it.
            let (mut low, mut high) = (start + 1, self.tube_count);
            while low < high {
                let middle = low.midpoint(high);
                match self.entries_before(middle) < before {
                    true => low = middle + 1,
                    false => high = middle,
                }
            }
            if low >= self.tube_count {
                break;
            }
            ranges.push(start..low);
            start = low;
        }
        ranges.push(start..self.tube_count);
        ranges
    }

    /// Appends the entries of a tube, in the order that they have in a single part.
    #[inline]
    pub(super) fn gather<R: Real, const D: usize>(
        &self,
        boxes: &[Aabb<R, D>],
        tube: u32,
        entries: &mut Vec<Entry<R, D>>,
    ) {
        // Boxes are anywhere in memory. They are copied before they are sorted, so that no read has to wait for another.
        let mut read = |owners: &[Owner]| {
            entries.extend(owners.iter().map(|&owner| Entry {
                aabb: boxes[owner.index() as usize],
                owner,
            }));
        };
        if let [part] = &self.parts[..] {
            return read(part.tube(tube));
        }
        for are_ghosts in [false, true] {
            for part in &self.parts {
                let owners = part.tube(tube);
                let (homes, ghosts) = owners.split_at(owners.partition_point(|o| o.is_at_home()));
                read(if are_ghosts { ghosts } else { homes });
            }
        }
    }
}

/// How many boxes are counted before the list of ghosts gets more room.
const BATCH: usize = 256;

/// The entries of a part of the members, by tube: first the boxes whose own tube it is, then the ghosts, both in the order of the members.
///
/// An entry is only its owner here. Writing boxes to hundreds of places takes longer than reading them again, tube by tube: those
/// reads do not wait for each other.
#[derive(Clone, Debug, Default)]
pub(super) struct Part {
    /// Which of the members.
    range: Range<usize>,
    /// Whether one of their boxes is invalid.
    is_invalid: bool,
    /// The boxes too large for the grid.
    oversized: Vec<u32>,
    /// By member its own tube; for an oversized one, the tube past the last.
    homes: Vec<u32>,
    /// The ghosts; those past their count are unspecified.
    ghosts: Vec<Ghost>,
    ghost_count: usize,
    /// By tube, for the tube past the last, and for the end: first the number of entries, one place further on; then where they start in
    /// `owners`.
    starts: Vec<u32>,
    /// The owners of the entries, tube after tube.
    owners: Vec<Owner>,
}

impl Part {
    /// Counts the entries of each tube, and finds out whether a box is invalid.
    ///
    /// Whether a box has a ghost is practically random, so there is no branch on it: every box writes to the list of ghosts, which
    /// grows by those that exist.
    fn count<R: Real, const D: usize>(&mut self, members: Members<R, D>, grid: &Grid<R>) {
        let (oversized, counts) = (&mut self.oversized, &mut self.starts);
        let (range, homes, ghosts) = (&self.range, &mut self.homes, &mut self.ghosts);
        let tube_count = grid.tube_count();
        oversized.clear();
        counts.clear();
        counts.resize(tube_count as usize + 2, 0);
        let counts = &mut counts[1..];
        homes.resize(range.len(), 0);
        let mut ghost_count = 0;
        let mut is_invalid = false;
        for (start, homes) in range.clone().step_by(BATCH).zip(homes.chunks_mut(BATCH)) {
            let room = ghost_count + homes.len() * MAX_GHOSTS;
            if ghosts.len() < room {
                ghosts.resize(room + ghost_count, Ghost::default());
            }
            let ghosts = &mut ghosts[..room];
            for (i, home) in (start..).zip(homes) {
                let index = members.index(i);
                let aabb = &members.boxes[index as usize];
                is_invalid |= !aabb.is_valid();
                let span = grid.tube_span(aabb);
                if grid.is_oversized(aabb, &span) {
                    oversized.push(index);
                    *home = tube_count;
                    counts[tube_count as usize] += 1;
                    continue;
                }
                let tube = grid.tube(span.first);
                *home = tube;
                counts[tube as usize] += 1;
                let list = ghosts[ghost_count..]
                    .first_chunk_mut()
                    .expect("there is room");
                ghost_count +=
                    Ghost::write_all::<D>(index, grid.next_tubes(tube), span.beyond(), list);
            }
        }
        for ghost in &ghosts[..ghost_count] {
            counts[ghost.tube as usize] += 1;
        }
        self.ghost_count = ghost_count;
        self.is_invalid = is_invalid;
    }

    /// Places the counted entries.
    fn place<R: Real, const D: usize>(&mut self, members: Members<R, D>) {
        let next = &mut self.starts[1..];
        let total = starts_from_counts(next) as usize;
        // Every entry that is read later is written below, so old ones need not be cleared.
        if self.owners.len() < total {
            self.owners.resize(total, Owner::default());
        }
        let owners = &mut self.owners[..];
        for (i, &home) in self.range.clone().zip(&self.homes) {
            owners[take_place(next, home as usize)] = Owner(members.index(i));
        }
        for ghost in &self.ghosts[..self.ghost_count] {
            owners[take_place(next, ghost.tube as usize)] = ghost.owner;
        }
    }

    /// The owners of a tube's entries.
    #[inline]
    fn tube(&self, tube: u32) -> &[Owner] {
        let [start, end] = [tube, tube + 1].map(|tube| self.starts[tube as usize] as usize);
        &self.owners[start..end]
    }
}
