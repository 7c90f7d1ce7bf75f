//! Notes of which slots were written since the last update.

/// Slots in the order of writing; a slot may repeat. Where several threads write, each has notes of its own.
#[derive(Clone, Debug, Default)]
pub(crate) struct Notes {
    /// Slots whose boxes or keys were written.
    pub(crate) touched: Vec<u32>,
    /// Those of them that the update searches for again: their boxes have left their fat boxes at some time since, are new or gone, or their
    /// keys have changed.
    pub(crate) leavers: Vec<u32>,
    /// Slots whose volumes have changed, or are stale and must be read.
    pub(crate) revolumed: Vec<u32>,
}

impl Notes {
    fn lists(&mut self) -> [&mut Vec<u32>; 3] {
        [&mut self.touched, &mut self.leavers, &mut self.revolumed]
    }

    /// Moves the notes of a thread to the end of these.
    pub(crate) fn append(&mut self, other: &mut Self) {
        for (all, more) in self.lists().into_iter().zip(other.lists()) {
            all.append(more);
        }
    }

    /// Removes repeats from each list that is longer than `most`. **O(log n)** per note, amortized.
    pub(crate) fn forget_repeats(&mut self, most: usize) {
        for list in self.lists() {
            if list.len() > most {
                list.sort_unstable();
                list.dedup();
            }
        }
    }

    pub(super) fn clear(&mut self) {
        self.lists().into_iter().for_each(Vec::clear);
    }
}
