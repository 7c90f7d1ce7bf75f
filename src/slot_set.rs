//! A set of slots that remembers the order in which they were inserted.

use crate::tuning::update::CLEAR_ALL_FROM_ONE_IN;

/// A set of slots, as a list and as flags: each operation takes constant time, except that iterating and clearing take
/// time in proportion to its members.
///
/// Flags take eight times the memory of a [`BitSet`](crate::bit_set::BitSet), but a tenth less time to ask for all
/// candidates.
#[derive(Clone, Debug, Default)]
pub(crate) struct SlotSet {
    slots: Vec<u32>,
    is_member: Vec<bool>,
}

impl SlotSet {
    /// Makes room for this number of slots; only those may be inserted.
    pub(crate) fn make_room(&mut self, slots: usize) {
        if slots > self.is_member.len() {
            self.is_member.resize(slots, false);
        }
    }

    pub(crate) fn insert(&mut self, slot: u32) {
        if !std::mem::replace(&mut self.is_member[slot as usize], true) {
            self.slots.push(slot);
        }
    }

    #[inline(always)]
    pub(crate) fn contains(&self, slot: u32) -> bool {
        self.is_member.get(slot as usize) == Some(&true)
    }

    /// The slots, in the order in which they were inserted.
    pub(crate) fn slots(&self) -> &[u32] {
        &self.slots
    }

    pub(crate) fn len(&self) -> usize {
        self.slots.len()
    }

    pub(crate) fn clear(&mut self) {
        if self.slots.len() > self.is_member.len() / CLEAR_ALL_FROM_ONE_IN {
            self.is_member.fill(false);
        } else {
            for &slot in &self.slots {
                self.is_member[slot as usize] = false;
            }
        }
        self.slots.clear();
    }
}
