//! Pairs on their way to the output.
//!
//! Most boxes have a few candidates, and how many of them are hits is practically random: a branch on it would be mispredicted for every
//! other box. So one loop goes through the hits of several boxes, and a single candidate is written to the buffer whether it is a hit or not.

use super::entry::Owner;
use crate::lanes::{ARE_VECTORS, LANES};
use crate::pair_finder::ordered;

/// How many pairs the buffer holds.
const BUFFER: usize = 512;

/// Collects pairs and appends them to a list. Leaves out the pairs of ghosts on the same axis: another tube reports them.
///
/// After more than `most` pairs it only counts them, until whoever emits them asks [`is_over`](Emitter::is_over).
pub(super) struct Emitter<'a> {
    pairs: &'a mut Vec<[u32; 2]>,
    /// The length of the list at the start.
    first: usize,
    buffer: [[u32; 2]; BUFFER],
    len: usize,
    most: usize,
    /// The pairs emitted, without those in the buffer.
    flushed: usize,
}

impl<'a> Emitter<'a> {
    pub(super) fn new(pairs: &'a mut Vec<[u32; 2]>, most: usize) -> Self {
        Self {
            first: pairs.len(),
            pairs,
            buffer: [[0; 2]; BUFFER],
            len: 0,
            most,
            flushed: 0,
        }
    }

    /// Emits the pairs of `owner` with those of the eight others whose bit in `hits` is set.
    #[inline(always)]
    pub(super) fn emit(&mut self, owner: Owner, others: &[Owner; LANES], mut hits: u32) {
        if !ARE_VECTORS {
            // The window has one candidate, and has found that it overlaps.
            return self.emit_one(owner, others[0], true);
        }
        if self.len > BUFFER - LANES {
            self.flush();
        }
        while hits != 0 {
            let other = others[hits.trailing_zeros() as usize % LANES];
            hits &= hits - 1;
            self.append(owner, other, true);
        }
    }

    /// Emits one pair if it is a hit.
    #[inline(always)]
    pub(super) fn emit_one(&mut self, owner: Owner, other: Owner, is_hit: bool) {
        if self.len == BUFFER {
            self.flush();
        }
        self.append(owner, other, is_hit);
    }

    /// Emits one pair if it is a hit. The buffer must have room.
    #[inline(always)]
    fn append(&mut self, owner: Owner, other: Owner, is_hit: bool) {
        self.buffer[self.len % BUFFER] = ordered(owner.index(), other.index());
        // A branch would be mispredicted.
        self.len += usize::from(is_hit & !owner.shares_axis(other));
    }

    /// Emits the pairs of a few entries with those that follow them. Each entry `i` has `SHIFTS` bits: bit `s` for entry `i + 1 + s`.
    #[inline(always)]
    pub(super) fn emit_shifted<const SHIFTS: usize, const N: usize>(
        &mut self,
        owners: &[Owner; N],
        mut hits: u64,
    ) {
        const { assert!(N >= 64 / SHIFTS + SHIFTS, "each entry has `SHIFTS` others") };
        if self.len > BUFFER - 64 {
            self.flush();
        }
        while hits != 0 {
            let hit = hits.trailing_zeros() as usize % 64;
            hits &= hits - 1;
            let first = hit / SHIFTS;
            let other = first + 1 + hit % SHIFTS;
            self.append(owners[first], owners[other], true);
        }
    }

    /// How many pairs were emitted.
    #[inline(always)]
    pub(super) fn count(&self) -> usize {
        self.flushed + self.len
    }

    /// Takes back all pairs but the first ones, unless more were emitted than may be appended.
    pub(super) fn take_back(&mut self, count: usize) {
        self.len = count.saturating_sub(self.flushed);
        self.flushed = self.flushed.min(count);
        self.pairs.truncate(self.first + self.flushed);
    }

    /// Whether more pairs were emitted than may be appended.
    pub(super) fn is_over(&self) -> bool {
        self.flushed > self.most
    }

    /// Appends the pairs in the buffer to the list.
    pub(super) fn flush(&mut self) {
        self.flushed += self.len;
        if !self.is_over() {
            self.pairs.extend_from_slice(&self.buffer[..self.len]);
        }
        self.len = 0;
    }
}
