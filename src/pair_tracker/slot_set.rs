//! A set of slots.

/// A set of slots, as a list and as a table of flags: each operation takes constant time, and going through it
/// or clearing it no more than it has members.
#[derive(Clone, Debug, Default)]
pub(crate) struct SlotSet {
    slots: Vec<u32>,
    contains: Vec<bool>,
}

impl SlotSet {
    pub(crate) fn insert(&mut self, slot: u32) {
        let index = slot as usize;
        if index >= self.contains.len() {
            self.contains.resize(index + 1, false);
        }
        if !self.contains[index] {
            self.contains[index] = true;
            self.slots.push(slot);
        }
    }

    #[inline(always)]
    pub(crate) fn contains(&self, slot: u32) -> bool {
        self.contains.get(slot as usize) == Some(&true)
    }

    /// The slots, in the order in which they came.
    pub(crate) fn slots(&self) -> &[u32] {
        &self.slots
    }

    pub(crate) fn clear(&mut self) {
        if self.slots.len() > self.contains.len() / 4 {
            self.contains.fill(false);
        } else {
            for &slot in &self.slots {
                self.contains[slot as usize] = false;
            }
        }
        self.slots.clear();
    }
}
