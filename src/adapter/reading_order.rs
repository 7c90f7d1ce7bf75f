//! In which order listed colliders are read.
//!
//! Rapier lists them in the order of its islands, which hops about in memory once bodies have met. In the
//! order of their indices the processor can see the next ones coming, which in scenes too large for the caches
//! halves the time of reading them. The order decides nothing else.

use super::rapier::geometry::ColliderHandle;

/// Up to this many colliders fit the caches in any order.
const FEW: usize = 256;

/// Whether the order of these handles is good enough as it is.
pub(super) fn is_favourable(handles: &[ColliderHandle]) -> bool {
    handles.len() <= FEW || handles.is_sorted_by_key(|handle| handle.into_raw_parts().0)
}

/// A set of slots to be read in their order; keeps its memory between calls.
#[derive(Clone, Debug, Default)]
pub(super) struct ReadingOrder {
    /// One bit for each slot.
    listed: Vec<u64>,
}

impl ReadingOrder {
    /// Makes room for so many slots.
    pub(super) fn reserve(&mut self, slots: usize) {
        self.listed.resize(slots.div_ceil(64), 0);
    }

    /// Adds a slot, of those there is room for.
    #[inline(always)]
    pub(super) fn insert(&mut self, slot: u32) {
        self.listed[slot as usize / 64] |= 1 << (slot % 64);
    }

    /// The bits, which may be cleared.
    pub(super) fn listed(&mut self) -> &mut [u64] {
        &mut self.listed
    }

    /// Takes all slots out of the set, each once, and in order.
    #[inline(always)]
    pub(super) fn drain(&mut self) -> impl Iterator<Item = u32> + '_ {
        let words = self.listed.iter_mut().zip((0..).step_by(64));
        words.flat_map(|(word, first)| {
            let mut bits = std::mem::take(word);
            core::iter::from_fn(move || {
                let bit = bits.checked_sub(1).map(|_| bits.trailing_zeros())?;
                bits &= bits - 1;
                Some(first + bit)
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slots_are_read_once_and_in_order() {
        let mut order = ReadingOrder::default();
        for slots in [0, 1, 64, 1000] {
            order.reserve(slots as usize);
            // Shuffled by a multiplication, and every tenth twice.
            let shuffled = (0..slots).map(|i| i * 37 % slots).filter(|i| i % 3 == 0);
            let again = (0..slots).step_by(30);
            shuffled.chain(again).for_each(|slot| order.insert(slot));
            let expected: Vec<_> = (0..slots).step_by(3).collect();
            assert!(order.drain().eq(expected));
            assert_eq!(order.drain().next(), None);
        }
    }

    #[test]
    fn few_or_ordered_handles_are_left_as_they_are() {
        let handles = |slots: &[u32]| -> Vec<_> {
            let handle = |&slot| ColliderHandle::from_raw_parts(slot, 0);
            slots.iter().map(handle).collect()
        };
        assert!(is_favourable(&handles(&[])));
        assert!(is_favourable(&handles(&[3, 1, 2])));
        let mut many: Vec<_> = (0..1000).collect();
        assert!(is_favourable(&handles(&many)));
        many.swap(10, 500);
        assert!(!is_favourable(&handles(&many)));
    }
}
