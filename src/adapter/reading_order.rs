//! In which order listed colliders are read.
//!
//! Rapier lists them in the order of its islands, which hops about in memory once bodies have met. In the
//! order of their indices the processor can see the next ones coming, which in scenes too large for the caches
//! halves the time of reading them. The order decides nothing else.

use super::rapier::geometry::ColliderHandle;

/// Up to this many colliders fit the caches in any order.
const FEW: usize = 256;

/// Puts handles in the order of their indices; keeps its memory between calls.
#[derive(Clone, Debug, Default)]
pub(super) struct ReadingOrder {
    /// One bit for each index.
    listed: Vec<u64>,
    /// For each listed index, the generation of its handle.
    generations: Vec<u32>,
}

impl ReadingOrder {
    /// Calls `read` with each of the handles, in a favourable order.
    pub(super) fn for_each(
        &mut self,
        handles: &[ColliderHandle],
        known_slots: usize,
        mut read: impl FnMut(ColliderHandle),
    ) {
        let index = |handle: &ColliderHandle| handle.into_raw_parts().0;
        if handles.len() <= FEW || handles.is_sorted_by_key(index) {
            handles.iter().copied().for_each(read);
            return;
        }
        self.generations.resize(known_slots, 0);
        self.listed.resize(known_slots.div_ceil(64), 0);
        for &handle in handles {
            let (index, generation) = handle.into_raw_parts();
            let slot = index as usize;
            if slot >= known_slots {
                // New or unheard of: few, as a rule.
                read(handle);
                continue;
            }
            let (word, bit) = (slot / 64, 1 << (slot % 64));
            if self.listed[word] & bit != 0 && self.generations[slot] != generation {
                // Two handles of one index: at most one of them is alive.
                read(handle);
                continue;
            }
            self.listed[word] |= bit;
            self.generations[slot] = generation;
        }
        for (word, first) in self.listed.iter_mut().zip((0..).step_by(64)) {
            let mut bits = std::mem::take(word);
            while bits != 0 {
                let slot = first + bits.trailing_zeros();
                bits &= bits - 1;
                read(ColliderHandle::from_raw_parts(
                    slot,
                    self.generations[slot as usize],
                ));
            }
        }
    }
}
