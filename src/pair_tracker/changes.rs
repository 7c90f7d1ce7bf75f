//! The changes of an update, reported in one canonical order.
//!
//! First the ended pairs are reported, then the new ones, both sorted by the smaller slot and then by the larger one. A pair changes at most
//! once in an update, so the order of the events does not depend on the order in which the changes were found.
//!
//! The order matters for speed as well: Rapier goes through pairs in the order of their events. For a solver that processes one contact after
//! the other, and stalls if it shares a body with the one before, the new pairs are split into two runs, which are interleaved. See "The order
//! of events" in docs/dev/design-notes.md.

/// The changes of an update. Updates reuse its memory.
#[derive(Clone, Debug)]
pub(crate) struct Changes {
    runs: usize,
    deleted: Vec<u64>,
    added: Vec<u64>,
}

impl Changes {
    /// No changes. New pairs will be split into this many interleaved runs, at least one.
    pub(crate) fn new(runs: usize) -> Self {
        Self {
            runs,
            deleted: Vec::new(),
            added: Vec::new(),
        }
    }

    /// Adds a pair that begins or ends, by slots, smaller first.
    #[inline]
    pub(super) fn push(&mut self, is_added: bool, pair: [u32; 2]) {
        match is_added {
            true => self.added.push(pack(pair)),
            false => self.deleted.push(pack(pair)),
        }
    }

    /// Calls `each` with every change in order, whether the pair begins and its slots, and removes them all. Returns the numbers of ended and
    /// of new pairs. Computes in **O(n log n)** time, and in **O(n)** if the changes were added in order.
    pub(crate) fn drain(&mut self, mut each: impl FnMut(bool, [u32; 2])) -> [usize; 2] {
        let counts = [self.deleted.len(), self.added.len()];
        // Packed pairs compare as single numbers, not slot by slot.
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

/// A number for each pair, in the order of the pairs.
pub(super) fn pack([smaller, larger]: [u32; 2]) -> u64 {
    u64::from(smaller) << 32 | u64::from(larger)
}

fn unpack(pair: u64) -> [u32; 2] {
    [(pair >> 32) as u32, pair as u32]
}
