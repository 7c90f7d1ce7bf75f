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
    ordered: Vec<ColliderHandle>,
}

impl ReadingOrder {
    /// The same handles, but for repetitions, in a favourable order.
    pub(super) fn arrange<'a>(
        &'a mut self,
        handles: &'a [ColliderHandle],
        known_slots: usize,
    ) -> &'a [ColliderHandle] {
        let index = |handle: &ColliderHandle| handle.into_raw_parts().0;
        if handles.len() <= FEW || handles.is_sorted_by_key(index) {
            return handles;
        }
        self.ordered.clear();
        self.generations.resize(known_slots, 0);
        self.listed.resize(known_slots.div_ceil(64), 0);
        for &handle in handles {
            let (index, generation) = handle.into_raw_parts();
            let slot = index as usize;
            if slot >= known_slots {
                // New or unheard of: few, as a rule.
                self.ordered.push(handle);
                continue;
            }
            let (word, bit) = (slot / 64, 1 << (slot % 64));
            if self.listed[word] & bit != 0 && self.generations[slot] != generation {
                // Two handles of one index: at most one of them is alive.
                self.ordered.push(handle);
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
                let generation = self.generations[slot as usize];
                self.ordered
                    .push(ColliderHandle::from_raw_parts(slot, generation));
            }
        }
        &self.ordered
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(order: &mut ReadingOrder, handles: &[ColliderHandle], slots: usize) -> Vec<(u32, u32)> {
        let arranged = order.arrange(handles, slots).iter();
        arranged.map(|handle| handle.into_raw_parts()).collect()
    }

    #[test]
    fn every_handle_is_read_and_known_ones_in_the_order_of_their_indices() {
        let mut order = ReadingOrder::default();
        for round in 0..3 {
            // 1,000 handles, each index once, shuffled by a multiplication; 100 of them unknown.
            let handles: Vec<_> = (0..1000)
                .map(|i| ColliderHandle::from_raw_parts(i * 37 % 1000, round))
                .collect();
            let read = read(&mut order, &handles, 900);
            let known: Vec<_> = read.iter().filter(|(index, _)| *index < 900).collect();
            assert!(known.is_sorted());
            let mut all = read.clone();
            all.sort_unstable();
            assert!(all.into_iter().eq((0..1000).map(|index| (index, round))));
        }
    }

    #[test]
    fn both_generations_of_an_index_are_read_and_repetitions_once() {
        let mut order = ReadingOrder::default();
        let mut handles: Vec<_> = (0..300)
            .rev()
            .map(|i| ColliderHandle::from_raw_parts(i, 1))
            .collect();
        handles.push(ColliderHandle::from_raw_parts(7, 0));
        handles.push(ColliderHandle::from_raw_parts(8, 1));
        handles.push(ColliderHandle::from_raw_parts(u32::MAX, u32::MAX));
        let mut read = read(&mut order, &handles, 300);
        assert_eq!(read.len(), 302);
        read.sort_unstable();
        read.dedup();
        assert_eq!(read.len(), 302);
        assert!(read.contains(&(7, 0)) && read.contains(&(7, 1)));
    }
}
