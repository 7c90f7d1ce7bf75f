//! The changes of an update, in the one order in which they are reported.
//!
//! Rapier's narrow phase keeps pairs in the order in which they were added, and narrow phase and solver go through them in that order
//! in each step. By slots, they meet colliders and bodies in the order in which they lie in memory. Steps are faster so, with as many
//! instructions and simulated cache misses as in the order of finding; presumably because the processor fetches ahead what lies in
//! order. So pairs end first, then others begin, both by the smaller slot and then by the larger one. A pair changes at most once in
//! an update, so this leaves nothing open: the same changes are reported in the same order, in whatever order they were found.
//!
//! A solver that takes one contact after the other waits wherever a contact shares a body with the one before it, as neighbours by
//! slots do. For such a solver, what begins is cut in two runs, whose pairs take turns. Within each of them an impulse still passes from
//! body to body in one iteration; if every other pair came first and then the rest, high stacks would fall sooner.

use crate::pair_tracker::PairChange;

/// The changes of an update; keeps its memory between updates.
#[derive(Clone, Debug)]
pub(crate) struct Changes {
    runs: usize,
    deleted: Vec<u64>,
    added: Vec<u64>,
}

impl Changes {
    /// No changes yet. What begins is cut in this many runs that take turns, at least one.
    pub(crate) fn new(runs: usize) -> Self {
        Self {
            runs,
            deleted: Vec::new(),
            added: Vec::new(),
        }
    }

    /// Notes a change.
    #[inline]
    pub(super) fn note(&mut self, change: PairChange) {
        match change {
            PairChange::Added(pair) => self.added.push(pack(pair)),
            PairChange::Deleted(pair) => self.deleted.push(pack(pair)),
        }
    }

    /// Forgets all changes, after it has given each of them away in order: whether the pair begins, and its slots. Returns how many
    /// pairs have ended, and how many have begun.
    ///
    /// Computes in **O(n log n)** time, and in **O(n)** if they are noted in order.
    pub(super) fn drain(&mut self, mut each: impl FnMut(bool, [u32; 2])) -> [usize; 2] {
        let counts = [self.deleted.len(), self.added.len()];
        // As numbers: pairs would be compared slot by slot.
        self.deleted.sort_unstable();
        self.added.sort_unstable();
        for pair in self.deleted.drain(..) {
            each(false, unpack(pair));
        }
        let run = self.added.len().div_ceil(self.runs);
        for place in 0..run {
            for &pair in self.added.iter().skip(place).step_by(run) {
                each(true, unpack(pair));
            }
        }
        self.added.clear();
        counts
    }
}

/// A number that is ordered as the pair.
fn pack([smaller, larger]: [u32; 2]) -> u64 {
    u64::from(smaller) << 32 | u64::from(larger)
}

fn unpack(pair: u64) -> [u32; 2] {
    [(pair >> 32) as u32, pair as u32]
}
