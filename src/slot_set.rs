//! A set of slots that remembers the order in which they came.

use crate::bit_set::BitSet;

/// A set of slots, as a list and as bits: each operation takes constant time, and going through it or clearing it no more
/// than it has members.
#[derive(Clone, Debug, Default)]
pub(crate) struct SlotSet {
    slots: Vec<u32>,
    members: BitSet,
}

impl SlotSet {
    /// Makes room for so many slots; only those may be inserted.
    pub(crate) fn make_room(&mut self, slots: usize) {
        self.members.resize(slots);
    }

    pub(crate) fn insert(&mut self, slot: u32) {
        if self.members.insert(slot as usize) {
            self.slots.push(slot);
        }
    }

    #[inline(always)]
    pub(crate) fn contains(&self, slot: u32) -> bool {
        self.members.contains(slot as usize)
    }

    /// The slots, in the order in which they came.
    pub(crate) fn slots(&self) -> &[u32] {
        &self.slots
    }

    pub(crate) fn len(&self) -> usize {
        self.slots.len()
    }

    pub(crate) fn clear(&mut self) {
        self.members.clear_around(&self.slots);
        self.slots.clear();
    }
}
