//! A set of slots that remembers the order in which they were inserted.

/// One slot in this many. A set of more slots is cleared by overwriting all flags. If larger: flags of slots outside the set are
/// written. If smaller: the slots of the set are visited one by one, in any order.
const CLEAR_ALL_FROM_ONE_IN: usize = 4;

/// A set of slots, as a list and as flags. Iterating and clearing take time in proportion to the members, everything else takes constant
/// time.
///
/// Flags take eight times the memory of a [`BitSet`](crate::bit_set::BitSet), but testing all candidates against them takes a tenth less
/// time.
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

    /// The slots, in the order of their insertion.
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
