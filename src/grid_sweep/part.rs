//! A part of the boxes, assigned to tubes by one thread.
//!
//! Threads share out the boxes, not the tubes, so each box is read by one thread only. What a tube holds is put together
//! from the parts. Within a part this is a counting sort: [`count`](Part::count), then [`place`](Part::place).

use std::ops::Range;

use super::grid::Grid;
use super::members::Members;
use super::owner::{Ghost, MAX_GHOSTS, Owner};
use crate::aabb::Aabb;
use crate::counting_sort::{starts_from_counts, take_place};
use crate::real::Real;

/// How many boxes are looked at before there is made room for the ghosts of as many more.
const BATCH: usize = 256;

/// The entries by tube, in each first the boxes whose own tube it is, then ghosts, both in the order of the members.
///
/// An entry is no more than its owner. To write the boxes themselves to hundreds of places takes longer than to read them
/// again, once for each tube: these reads do not wait for each other.
#[derive(Clone, Debug, Default)]
pub(super) struct Part {
    /// Which of the members.
    pub(super) range: Range<usize>,
    /// Whether one of their boxes is invalid.
    pub(super) is_invalid: bool,
    /// The boxes too large for the grid.
    pub(super) oversized: Vec<u32>,
    /// For each member its own tube; that of an oversized one is the tube past the last.
    homes: Vec<u32>,
    /// The ghosts; those past their count are unspecified.
    ghosts: Vec<Ghost>,
    ghost_count: usize,
    /// For each tube of the grid and the one past the last: how many entries there are, once they are counted, and where they
    /// end in `owners`, once they are placed.
    pub(super) ends: Vec<u32>,
    /// Whose the entries are, tube after tube.
    pub(super) owners: Vec<Owner>,
}

impl Part {
    /// Counts the entries of each tube for the members of the range, and takes down whether one of their boxes is invalid.
    ///
    /// Whether a box has a ghost is practically random. So there is no branch on it: ghosts are always written to a list,
    /// which grows by those that exist.
    pub(super) fn count<R: Real, M: Members, const D: usize>(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: M,
        grid: &Grid<R>,
    ) {
        let (oversized, counts) = (&mut self.oversized, &mut self.ends);
        let (range, homes, ghosts) = (&self.range, &mut self.homes, &mut self.ghosts);
        let tube_count = grid.tube_count();
        oversized.clear();
        counts.clear();
        counts.resize(tube_count as usize + 1, 0);
        let counts = &mut counts[..];
        homes.resize(range.len(), 0);
        let mut ghost_count = 0;
        let mut is_invalid = false;
        for (start, homes) in range.clone().step_by(BATCH).zip(homes.chunks_mut(BATCH)) {
            let room = ghost_count + homes.len() * MAX_GHOSTS;
            if ghosts.len() < room {
                ghosts.resize(room + ghost_count, Ghost::default());
            }
            let ghosts = &mut ghosts[..room];
            members.for_each(boxes, start..start + homes.len(), |i, index, aabb| {
                is_invalid |= M::MAY_BE_INVALID && !aabb.is_valid();
                let span = grid.tube_span(aabb);
                if grid.is_oversized(aabb, &span) {
                    oversized.push(index);
                    homes[i] = tube_count;
                    counts[tube_count as usize] += 1;
                    return;
                }
                let home = grid.tube(span.first);
                homes[i] = home;
                counts[home as usize] += 1;
                let list = ghosts[ghost_count..]
                    .first_chunk_mut()
                    .expect("there is room");
                ghost_count +=
                    Ghost::write_all::<D>(index, grid.next_tubes(home), span.beyond(), list);
            });
        }
        for ghost in &ghosts[..ghost_count] {
            counts[ghost.tube as usize] += 1;
        }
        self.ghost_count = ghost_count;
        self.is_invalid = is_invalid;
    }

    /// Places the entries that were counted.
    pub(super) fn place(&mut self, members: impl Members) {
        let next = &mut self.ends[..];
        let total = starts_from_counts(next) as usize;
        // All that is read later is written below, so what the last call left need not be cleared.
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

    /// How many entries there are in the tubes before this one.
    pub(super) fn entries_before(&self, tube: u32) -> u32 {
        match tube {
            0 => 0,
            _ => self.ends[tube as usize - 1],
        }
    }

    /// Whose the entries of a tube are.
    #[inline]
    pub(super) fn tube(&self, tube: u32) -> &[Owner] {
        &self.owners[self.entries_before(tube) as usize..self.ends[tube as usize] as usize]
    }
}
