//! Held pairs whose candidates are retired and whose boxes overlap, until the search has found them again.

use crate::tuning::update::KEEP_SCRATCH_UP_TO;

/// The end of a list.
const END: u32 = u32::MAX;

/// A set of pairs. In each update it is filled, indexed, asked, and emptied, in this order.
#[derive(Clone, Debug, Default)]
pub(super) struct RetiredPairs {
    /// By hash, the first entry of a list. Their number is a power of two, and at least the number of entries.
    heads: Vec<u32>,
    pub(super) entries: Vec<Entry>,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    pair: [u32; 2],
    next: u32,
}

impl RetiredPairs {
    /// Adds a pair that is not in the set.
    pub(super) fn insert(&mut self, pair: [u32; 2]) {
        self.entries.push(Entry { pair, next: END });
    }

    /// Prepares for [`contains`](Self::contains).
    pub(super) fn index(&mut self) {
        let count = self.entries.len().next_power_of_two().max(2);
        self.heads.clear();
        self.heads.resize(count, END);
        for (link, entry) in (0..).zip(&mut self.entries) {
            let head = &mut self.heads[hash(entry.pair, count)];
            entry.next = std::mem::replace(head, link);
        }
    }

    /// Whether a pair is in the set, which must be indexed.
    pub(super) fn contains(&self, pair: [u32; 2]) -> bool {
        let mut link = self.heads[hash(pair, self.heads.len())];
        while link != END {
            let entry = &self.entries[link as usize];
            if entry.pair == pair {
                return true;
            }
            link = entry.next;
        }
        false
    }

    /// Frees the memory of an empty set if it is large.
    pub(super) fn free_if_large(&mut self) {
        if self.entries.capacity() > KEEP_SCRATCH_UP_TO {
            *self = Self::default();
        }
    }
}

/// A number below `count`, which is a power of two above 1. Fibonacci hashing (Knuth, The Art of Computer Programming, 6.4).
#[inline(always)]
fn hash([a, b]: [u32; 2], count: usize) -> usize {
    let key = u64::from(a) << 32 | u64::from(b);
    (key.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> (64 - count.trailing_zeros())) as usize
}
