//! Pairs on their way to the output.
//!
//! Most boxes have a few candidates, and how many of them are hits is practically random; a branch on that would be
//! mispredicted for every other box. So pairs are written to a buffer whether they are hits or not, and the cursor moves on by
//! the hits; or the hits of several boxes are gone through in one loop.

use super::owner::Owner;
use crate::lanes::LANES;
use crate::pair_finder::ordered;

/// What was done, in numbers.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tally {
    /// Pairs that were emitted, also if nobody wants them.
    pub(crate) emitted: usize,
    /// Those of them that nobody wants.
    pub(crate) unwanted: usize,
    /// Boxes that were compared with another, and tubes visited.
    pub(crate) compared: usize,
}

impl std::ops::AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.emitted += other.emitted;
        self.unwanted += other.unwanted;
        self.compared += other.compared;
    }
}

/// How many pairs are collected before they are appended to the output.
const BUFFER: usize = 512;

/// Collects pairs and appends them to a list. Pairs of ghosts on the same axis are left out: another tube has them.
///
/// Once there are more than it may append, it only counts them.
pub(super) struct Emitter<'a> {
    pairs: &'a mut Vec<[u32; 2]>,
    /// How many pairs the list had before.
    first: usize,
    buffer: [[u32; 2]; BUFFER],
    len: usize,
    /// How many pairs were emitted, but for those in the buffer.
    flushed: usize,
    /// How many may be appended.
    pub(super) most: usize,
    /// How many boxes were compared with another to find the pairs, and tubes visited.
    pub(super) compared: usize,
}

impl<'a> Emitter<'a> {
    pub(super) fn new(pairs: &'a mut Vec<[u32; 2]>, most: usize) -> Self {
        Self {
            first: pairs.len(),
            pairs,
            buffer: [[0; 2]; BUFFER],
            len: 0,
            flushed: 0,
            most,
            compared: 0,
        }
    }

    /// Emits the pairs of `owner` with those of eight others whose bit in `hits` is set.
    #[inline(always)]
    pub(super) fn emit(&mut self, owner: Owner, others: &[Owner; LANES], mut hits: u32) {
        if self.len > BUFFER - LANES {
            self.flush();
        }
        let mut next = || {
            let other = others[hits.trailing_zeros() as usize % LANES];
            let is_hit = hits != 0;
            hits &= hits.wrapping_sub(1);
            (other, is_hit)
        };
        for _ in 0..2 {
            let (other, is_hit) = next();
            self.append(owner, other, is_hit);
        }
        while let (other, true) = next() {
            self.append(owner, other, true);
        }
    }

    /// Emits one pair, if it is a hit.
    #[inline(always)]
    pub(super) fn emit_one(&mut self, owner: Owner, other: Owner, is_hit: bool) {
        if self.len == BUFFER {
            self.flush();
        }
        self.append(owner, other, is_hit);
    }

    /// Emits one pair, if it is a hit. There must be room.
    #[inline(always)]
    fn append(&mut self, owner: Owner, other: Owner, is_hit: bool) {
        self.buffer[self.len % BUFFER] = ordered(owner.index(), other.index());
        // No branch: it would be mispredicted.
        self.len += usize::from(is_hit & !owner.shares_axis(other));
    }

    /// Emits the pairs of a few entries with those that follow them: of the entry `i`, bit `s` of as many bits as there
    /// are shifts is for the entry `i + 1 + s`.
    #[inline(always)]
    pub(super) fn emit_shifted<const SHIFTS: usize, const N: usize>(
        &mut self,
        owners: &[Owner; N],
        mut hits: u64,
    ) {
        const {
            assert!(
                N >= 64 / SHIFTS + SHIFTS,
                "the last entry has as many that follow"
            )
        };
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

    /// Counts pairs that are too many to be emitted.
    pub(super) fn give_up(&mut self, pairs: usize) {
        self.flushed += pairs;
    }

    /// Whether more pairs were emitted than may be appended.
    pub(super) fn is_over(&self) -> bool {
        self.flushed > self.most
    }

    /// Takes back all pairs but so many, if no more were emitted than may be appended.
    pub(super) fn take_back(&mut self, count: usize) {
        self.len = count.saturating_sub(self.flushed);
        self.flushed = self.flushed.min(count);
        self.pairs.truncate(self.first + self.flushed);
    }

    fn flush(&mut self) {
        self.flushed += self.len;
        if !self.is_over() {
            self.pairs.extend_from_slice(&self.buffer[..self.len]);
        }
        self.len = 0;
    }

    /// Appends what is left, and tells what it took.
    pub(super) fn finish(mut self) -> Tally {
        self.flush();
        Tally {
            emitted: self.flushed,
            compared: self.compared,
            unwanted: 0,
        }
    }
}
