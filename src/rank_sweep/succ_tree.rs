//! The active set: a set of small integers that knows its order.
//!
//! The paper's SuccTree: a tree of bits, which finds the neighbour of a value, and the stored values linked in order as
//! well (section 4 of the paper), so that walking from one to the next is a single step, however far apart they are.
//!
//! The tree is perfect and 64-ary, with one bit per node: a bit of the lowest level says that a value is stored, a bit of a
//! higher one that at least one value is stored below it. The 64 children of a node are one machine word, so the neighbour
//! of a value is found with a few shifts and bit scans per level, and there are few levels: four for two million values.
//! This is the tree of Capannini and Larsson, *Efficient collision culling by a succinct bi-dimensional sweep and prune
//! algorithm* (2016).

/// Bits of a value that one level decides.
const LEVEL_BITS: u32 = 6;

/// What is known of a stored value.
#[derive(Clone, Copy, Debug, Default)]
struct Node {
    /// The next greater stored value, or the universe's size.
    next: u32,
    /// The next smaller stored value, or the universe's size.
    prev: u32,
    /// The label it was inserted with.
    label: u32,
}

/// An ordered set of values below a bound, its *universe*, each with a label.
#[derive(Clone, Debug, Default)]
pub(super) struct SuccTree {
    /// The bits of all levels, the lowest first. The highest level is one word.
    words: Vec<u64>,
    /// Where in `words` each level starts.
    starts: Vec<usize>,
    /// By value. The last one is not a value; it closes the list to a ring: its `next` is the least stored value.
    nodes: Vec<Node>,
}

impl SuccTree {
    /// Empties the set and makes room for the values below `universe`.
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

    /// The next greater stored value after a stored one, or the universe's size.
    #[inline]
    pub(super) fn next(&self, value: u32) -> u32 {
        self.nodes[value as usize].next
    }

    /// The label of a stored value.
    #[inline]
    pub(super) fn label(&self, value: u32) -> u32 {
        self.nodes[value as usize].label
    }

    /// Stores a value that is not stored and returns the next greater one, or the universe's size.
    ///
    /// Computes in **O(log₆₄ universe)** time.
    #[inline]
    pub(super) fn insert(&mut self, value: u32, label: u32) -> u32 {
        let next = self.successor(value);
        self.insert_before(next, value, label);
        next
    }

    /// Stores a value that is not stored, of which the next greater one is known.
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

    /// The least stored value greater than one that is not stored, or the universe's size if there is none.
    #[inline]
    fn successor(&self, value: u32) -> u32 {
        let mut at = value as usize;
        for (level, start) in self.starts.iter().enumerate() {
            let word = self.words[start + (at >> LEVEL_BITS)];
            // Shifted in two steps: shifting by 64 is not defined.
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
