//! What one thread does of a search: it sweeps tubes or looks queries up, one task after the other, counts the work, and buffers the pairs.
//!
//! Most boxes have a few candidates, and how many of them are hits is practically random: a branch on it would be mispredicted for every
//! other box. So one loop goes through the hits of several boxes, and a single candidate is written to the buffer whether it is a hit or not.

use super::entry::Owner;
use crate::bit_set::ones;
use crate::pair_finder::ordered;
use crate::tuning::kernel::COMPARED_A_PAIR;

/// How many pairs the buffer holds.
const BUFFER: usize = 512;

/// The work of a search.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tally {
    /// Pairs that overlap, wanted or not.
    pub(crate) emitted: usize,
    /// Comparisons of two boxes, also those of a sweep that was given up, and visits of tubes in units of comparisons. With vectors, eight
    /// boxes count even if fewer are left.
    pub(crate) compared: u64,
}

/// Collects the pairs of a thread and appends them to a list. Leaves out the pairs of ghosts on the same axis: another tube reports them.
///
/// After more than `most` pairs it only counts them, until whoever emits them asks [`is_over`](Self::is_over).
pub(super) struct Worker<'a> {
    pairs: &'a mut Vec<[u32; 2]>,
    most: usize,
    buffer: [[u32; 2]; BUFFER],
    len: usize,
    /// The work so far, without the pairs in the buffer.
    pub(super) tally: Tally,
    /// The most comparisons by the end of the present task, besides some for each of its pairs.
    budget: u64,
    /// The pairs before the present task.
    before_task: usize,
}

impl<'a> Worker<'a> {
    /// Appends at most so many pairs to the list.
    pub(super) fn new(pairs: &'a mut Vec<[u32; 2]>, most: usize) -> Self {
        Self {
            pairs,
            most,
            buffer: [[0; 2]; BUFFER],
            len: 0,
            tally: Tally::default(),
            budget: u64::MAX,
            before_task: 0,
        }
    }

    /// Begins a task, with this many comparisons besides some for each of its pairs.
    pub(super) fn begin_task(&mut self, budget: u64) {
        self.before_task = self.tally.emitted + self.len;
        self.budget = self.tally.compared.saturating_add(budget);
    }

    /// Whether the task has taken more comparisons than it may, or more pairs were emitted than may be appended. Then the task must end.
    #[inline(always)]
    pub(super) fn is_budget_exceeded(&self) -> bool {
        let pairs = self.tally.emitted + self.len - self.before_task;
        let for_pairs = COMPARED_A_PAIR * pairs as u64;
        self.tally.compared >= self.budget.saturating_add(for_pairs) || self.is_over()
    }

    /// Emits a pair for each bit of `hits`: the one of these owners.
    #[inline(always)]
    pub(super) fn emit(&mut self, hits: u64, owners: impl Fn(usize) -> [Owner; 2]) {
        if self.len > BUFFER - 64 {
            self.flush();
        }
        for hit in ones(hits) {
            let [owner, other] = owners(hit);
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

    /// Takes back the pairs of the task. No more may have been emitted than may be appended.
    pub(super) fn take_back(&mut self) {
        let appended = self.tally.emitted.saturating_sub(self.before_task);
        self.pairs.truncate(self.pairs.len() - appended);
        self.len = self.before_task.saturating_sub(self.tally.emitted);
        self.tally.emitted -= appended;
    }

    /// Whether more pairs were emitted than may be appended.
    pub(super) fn is_over(&self) -> bool {
        self.tally.emitted > self.most
    }

    /// Appends the pairs in the buffer to the list.
    fn flush(&mut self) {
        self.tally.emitted += self.len;
        if !self.is_over() {
            self.pairs.extend_from_slice(&self.buffer[..self.len]);
        }
        self.len = 0;
    }

    /// Appends the rest of the pairs, and returns the work of all tasks.
    pub(super) fn finish(mut self) -> Tally {
        self.flush();
        self.tally
    }
}
