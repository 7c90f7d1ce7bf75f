//! A part of the boxes, dealt to the tubes by one thread.
//!
//! Threads share out the boxes, not the tubes, so each box is read by one thread only. What a tube holds is put together
//! from the parts: see [`Slab`](super::slab::Slab).

use std::ops::Range;

use super::ghosts::{Ghost, MAX_GHOSTS, write_ghosts};
use super::grid::Grid;
use super::members::Members;
use super::owner::Owner;
use crate::{Aabb, Real};

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
    /// Whose the entries are, tube after tube.
    owners: Vec<Owner>,
    /// For each tube of the grid, where its entries end, once they are there; before, how many there are. One more for
    /// outsize boxes, in the place of a tube of their own.
    ends: Vec<u32>,
    /// For each member its own tube.
    homes: Vec<u32>,
    /// The ghosts; those past their count are unspecified.
    ghosts: Vec<Ghost>,
    ghost_count: usize,
    /// The boxes too large for the grid.
    pub(super) outsize: Vec<u32>,
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
        let Self {
            range,
            ends,
            homes,
            ghosts,
            outsize,
            ..
        } = self;
        let columns = grid.axes[1].last + 1;
        let tube_count = grid.tube_count() as u32;
        outsize.clear();
        ends.clear();
        ends.resize(tube_count as usize + 1, 0);
        let ends = &mut ends[..];
        homes.resize(range.len(), 0);
        let mut ghost_count = 0;
        let mut is_invalid = false;
        for (start, homes) in range.clone().step_by(BATCH).zip(homes.chunks_mut(BATCH)) {
            let room = ghost_count + homes.len() * MAX_GHOSTS;
            if ghosts.len() < room {
                ghosts.resize(room + ghost_count, Ghost::default());
            }
            let ghosts = &mut ghosts[..room];
            members.for_each(boxes, start..start + homes.len(), |i, owner, aabb| {
                is_invalid |= M::MAY_BE_INVALID && !aabb.is_valid();
                let span = grid.tube_span(aabb);
                if span.is_outsize() {
                    outsize.push(owner);
                    homes[i] = tube_count;
                    ends[tube_count as usize] += 1;
                    return;
                }
                let home = span.first[0] * columns + span.first[1];
                homes[i] = home;
                ends[home as usize] += 1;
                let list = ghosts[ghost_count..]
                    .first_chunk_mut()
                    .expect("there is room");
                ghost_count += write_ghosts::<D>(owner, home, columns, span.beyond(), list);
            });
        }
        for ghost in &ghosts[..ghost_count] {
            ends[ghost.tube as usize] += 1;
        }
        self.ghost_count = ghost_count;
        self.is_invalid = is_invalid;
    }

    /// Places the entries that were counted.
    pub(super) fn place(&mut self, members: impl Members) {
        let Self {
            range,
            owners,
            ends,
            homes,
            ghosts,
            ghost_count,
            ..
        } = self;
        let mut total = 0;
        for end in &mut *ends {
            total += std::mem::replace(end, total);
        }
        // All that is read later is written below, so what the last call left need not be cleared.
        if owners.len() < total as usize {
            owners.resize(total as usize, Owner::default());
        }
        let (owners, ends) = (&mut owners[..], &mut ends[..]);
        let mut place = |tube: u32, owner: Owner| {
            let cursor = &mut ends[tube as usize];
            owners[*cursor as usize] = owner;
            *cursor += 1;
        };
        for (i, &home) in range.clone().zip(&*homes) {
            place(home, Owner::at_home(members.index(i)));
        }
        for ghost in &ghosts[..*ghost_count] {
            place(ghost.tube, ghost.owner);
        }
    }

    /// How many entries there are in the tubes before this one.
    fn entries_before(&self, tube: u32) -> u32 {
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

/// How many entries all parts have in the tubes before this one.
pub(super) fn entries_before(parts: &[Part], tube: u32) -> usize {
    let counts = parts.iter().map(|part| part.entries_before(tube) as usize);
    counts.sum()
}
