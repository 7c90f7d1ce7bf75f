//! The changes of an update, in the one order in which they are reported.
//!
//! Rapier's narrow phase keeps pairs in the order in which they were added, and goes through them in that order in each step. By
//! slots, it meets colliders and bodies in the order in which they lie in memory. Steps are faster so, with as many instructions and
//! simulated cache misses as in the order of finding; presumably because the processor fetches ahead what lies in order. So pairs end
//! first, then others begin, both by the smaller slot and then by the larger one. A pair changes at most once in an update, so this
//! leaves nothing open: the same changes are reported in the same order, in whatever order they were found.

use crate::pair_tracker::PairChange;

/// The changes of an update; keeps its memory between updates.
#[derive(Clone, Debug, Default)]
pub(crate) struct Changes {
    deleted: Vec<u64>,
    added: Vec<u64>,
}

impl Changes {
    /// Notes a change.
    #[inline]
    pub(super) fn note(&mut self, change: PairChange) {
        match change {
            PairChange::Added(pair) => self.added.push(pack(pair)),
            PairChange::Deleted(pair) => self.deleted.push(pack(pair)),
        }
    }

    /// Hands over all changes in order: the pairs that have ended, and those that have begun.
    ///
    /// Computes in **O(n log n)** time, and in **O(n)** if they are noted in order.
    pub(super) fn drain(&mut self) -> [impl ExactSizeIterator<Item = [u32; 2]> + '_; 2] {
        [&mut self.deleted, &mut self.added].map(|pairs| {
            // As numbers: pairs would be compared slot by slot.
            pairs.sort_unstable();
            pairs.drain(..).map(unpack)
        })
    }
}

/// A number that is ordered as the pair.
fn pack([smaller, larger]: [u32; 2]) -> u64 {
    u64::from(smaller) << 32 | u64::from(larger)
}

fn unpack(pair: u64) -> [u32; 2] {
    [(pair >> 32) as u32, pair as u32]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_end_before_others_begin_each_by_slots() {
        const MAX: u32 = u32::MAX;
        let mut changes = Changes::default();
        for _ in 0..2 {
            for pair in [[7, 9], [0, MAX], [2, 3], [7, 8], [0, 1]] {
                changes.note(PairChange::Added(pair));
            }
            for pair in [[MAX - 1, MAX], [5, 7], [5, 6]] {
                changes.note(PairChange::Deleted(pair));
            }
            let [deleted, added] = changes.drain().map(Vec::from_iter);
            assert_eq!(deleted, [[5, 6], [5, 7], [MAX - 1, MAX]]);
            assert_eq!(added, [[0, 1], [0, MAX], [2, 3], [7, 8], [7, 9]]);
        }
    }
}
