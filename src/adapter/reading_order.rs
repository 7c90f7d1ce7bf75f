//! In which order listed colliders are read.
//!
//! Rapier lists them in the order of its islands, which hops about in memory once bodies have met. In the
//! order of their indices the processor can see the next ones coming, which in scenes too large for the caches
//! halves the time of reading them. The order decides nothing else.

use super::rapier::geometry::ColliderHandle;
use crate::parallel::{self, ones};

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
    /// Adds the slots of those handles whose generation is the known one, and all others, in their order, to
    /// `strangers`; with `is_shared`, on several threads.
    pub(super) fn insert_known(
        &mut self,
        handles: &[ColliderHandle],
        generations: &[Option<u32>],
        strangers: &mut Vec<ColliderHandle>,
        is_shared: bool,
    ) {
        self.listed.resize(generations.len().div_ceil(64), 0);
        if !is_shared {
            insert_known(&mut self.listed, handles, generations, strangers);
            return;
        }
        let words = self.listed.len();
        let count = parallel::threads();
        let mut parts: Vec<_> = handles
            .chunks(handles.len().div_ceil(count).max(1))
            .map(|handles| (handles, vec![0; words], Vec::new()))
            .collect();
        parallel::for_each(&mut parts, |(handles, listed, strangers)| {
            insert_known(listed, handles, generations, strangers);
        });
        for (_, listed, mut others) in parts {
            let words = self.listed.iter_mut().zip(listed);
            words.for_each(|(word, more)| *word |= more);
            strangers.append(&mut others);
        }
    }

    /// The bits, which may be cleared.
    pub(super) fn listed(&mut self) -> &mut [u64] {
        &mut self.listed
    }

    /// Takes all slots out of the set, each once, and in order.
    #[inline(always)]
    pub(super) fn drain(&mut self, mut read: impl FnMut(u32)) {
        ones(&self.listed).for_each(|slot| read(slot as u32));
        self.listed.fill(0);
    }
}

fn insert_known(
    listed: &mut [u64],
    handles: &[ColliderHandle],
    generations: &[Option<u32>],
    strangers: &mut Vec<ColliderHandle>,
) {
    for &handle in handles {
        let (slot, generation) = handle.into_raw_parts();
        let slot = slot as usize;
        if generations.get(slot) == Some(&Some(generation)) {
            listed[slot / 64] |= 1 << (slot % 64);
        } else {
            strangers.push(handle);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slots_are_read_once_and_in_order_and_strangers_are_told_apart() {
        let mut order = ReadingOrder::default();
        for is_shared in [false, true] {
            for slots in [0_u32, 1, 64, 1000] {
                let known: Vec<_> = (0..slots).map(|i| (i % 5 != 0).then_some(7)).collect();
                // Shuffled by a multiplication, and every tenth twice.
                let shuffled = (0..slots).map(|i| i * 37 % slots);
                let again = (0..slots).step_by(10);
                let handles: Vec<_> = shuffled
                    .chain(again)
                    .chain([slots, u32::MAX])
                    .map(|slot| ColliderHandle::from_raw_parts(slot, 7))
                    .collect();
                let mut strangers = Vec::new();
                order.insert_known(&handles, &known, &mut strangers, is_shared);
                let mut read = Vec::new();
                order.drain(|slot| read.push(slot));
                assert!((0..slots).filter(|i| i % 5 != 0).eq(read));
                order.drain(|slot| panic!("{slot} is read again"));
                let is_stranger = |handle: &&ColliderHandle| {
                    known.get(handle.into_raw_parts().0 as usize) != Some(&Some(7))
                };
                assert!(handles.iter().filter(is_stranger).eq(&strangers));
            }
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
