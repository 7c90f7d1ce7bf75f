//! The active set: an ordered set of small integers.
//!
//! This is the SuccTree of the paper: a tree of bits finds the neighbour of a value, and the stored values are linked in order (section
//! 4 of the paper), so that the next one is a single step away at any distance.
//!
//! The tree is perfect and 64-ary, with one bit per node. A bit of the lowest level is set if its value is stored, and a bit of a higher
//! level if at least one value is stored below it. The 64 children of a node are one machine word. So finding a neighbour takes a few
//! shifts and bit scans per level, and there are few levels: four for two million values. The tree is that of Capannini and Larsson,
//! *Efficient collision culling by a succinct bi-dimensional sweep and prune algorithm* (2016).

/// How many bits of a value one level decides.
const LEVEL_BITS: u32 = 6;

/// A stored value.
#[derive(Clone, Copy, Debug, Default)]
struct Node {
    /// The next greater stored value, or the size of the universe.
    next: u32,
    /// The next smaller stored value, or the size of the universe.
    prev: u32,
    label: u32,
}

/// An ordered set of values below a bound, its *universe*, each with a label.
#[derive(Clone, Debug, Default)]
pub(super) struct SuccTree {
    /// The bits of all levels, the lowest first. The highest level is one word.
    words: Vec<u64>,
    /// The start of each level in `words`.
    starts: Vec<usize>,
    /// By value. The last node is not a value. It closes the list to a ring: its `next` is the least stored value.
    nodes: Vec<Node>,
}

impl SuccTree {
    /// Removes all values, and makes room for those below `universe`.
    ///
    /// Computes in **O(universe)** time.
    pub(super) fn reset(&mut self, universe: u32) {
        self.words.clear();
        self.starts.clear();
        let mut width = universe as usize;
        while self.starts.is_empty() || width > 1 {
            width = width.div_ceil(1 << LEVEL_BITS).max(1);
            self.starts.push(self.words.len());
            self.words.resize(self.words.len() + width, 0);
        }
        self.nodes.resize(universe as usize + 1, Node::default());
        let end = &mut self.nodes[universe as usize];
        (end.next, end.prev) = (universe, universe);
    }

    /// Returns the next greater stored value after a stored one, or the size of the universe.
    #[inline]
    pub(super) fn next(&self, value: u32) -> u32 {
        self.nodes[value as usize].next
    }

    /// Returns the label of a stored value.
    #[inline]
    pub(super) fn label(&self, value: u32) -> u32 {
        self.nodes[value as usize].label
    }

    /// Stores a value that is not stored, and returns the next greater stored value or the size of the universe.
    ///
    /// Computes in **O(log₆₄ universe)** time.
    #[inline]
    pub(super) fn insert(&mut self, value: u32, label: u32) -> u32 {
        let next = self.successor(value);
        self.insert_before(next, value, label);
        next
    }

    /// Stores a value that is not stored, if the next greater stored value is known.
    ///
    /// Computes in **O(log₆₄ universe)** time, and **O(1)** where the set is dense.
    #[inline]
    pub(super) fn insert_before(&mut self, next: u32, value: u32, label: u32) {
        let prev = core::mem::replace(&mut self.nodes[next as usize].prev, value);
        debug_assert!(prev as usize == self.nodes.len() - 1 || prev < value);
        self.nodes[prev as usize].next = value;
        self.nodes[value as usize] = Node { next, prev, label };
        let mut at = value as usize;
        for start in &self.starts {
            let word = &mut self.words[start + (at >> LEVEL_BITS)];
            let others = core::mem::replace(word, *word | 1 << (at & 63));
            if others != 0 {
                break;
            }
            at >>= LEVEL_BITS;
        }
    }

    /// Removes a stored value.
    ///
    /// Computes in **O(log₆₄ universe)** time, and **O(1)** where the set is dense.
    #[inline]
    pub(super) fn remove(&mut self, value: u32) {
        let Node { next, prev, .. } = self.nodes[value as usize];
        self.nodes[next as usize].prev = prev;
        self.nodes[prev as usize].next = next;
        let mut at = value as usize;
        for start in &self.starts {
            let word = &mut self.words[start + (at >> LEVEL_BITS)];
            *word &= !(1 << (at & 63));
            if *word != 0 {
                break;
            }
            at >>= LEVEL_BITS;
        }
    }

    /// Returns the least stored value greater than one that is not stored, or the size of the universe.
    #[inline]
    fn successor(&self, value: u32) -> u32 {
        let mut at = value as usize;
        for (level, start) in self.starts.iter().enumerate() {
            let word = self.words[start + (at >> LEVEL_BITS)];
            // Two shifts, because a shift by 64 is not defined.
            let above = word & (!0 << (at & 63) << 1);
            if above != 0 {
                at = at & !63 | above.trailing_zeros() as usize;
                for start in self.starts[..level].iter().rev() {
                    let word = self.words[start + at];
                    at = at << LEVEL_BITS | word.trailing_zeros() as usize;
                }
                return at as u32;
            }
            at >>= LEVEL_BITS;
        }
        self.nodes.len() as u32 - 1
    }
}
