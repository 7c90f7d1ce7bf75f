//! The active set: a set of small integers that knows its order.
//!
//! The paper's SuccTree: a tree of bits, which finds the neighbour of a value, and the stored values linked in order as
//! well (section 4 of the paper), so that walking from one to the next is a single step, however far apart they are.

use super::bit_tree::BitTree;

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
    /// Which values are stored.
    bits: BitTree,
    /// By value. The last one is not a value; it closes the list to a ring: its `next` is the least stored value.
    nodes: Vec<Node>,
}

impl SuccTree {
    /// Empties the set and makes room for the values below `universe`.
    ///
    /// Computes in **O(universe)** time.
    pub(super) fn reset(&mut self, universe: u32) {
        self.bits.reset(universe);
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
        let next = self.bits.successor(value);
        self.insert_before(next, value, label);
        next
    }

    /// Stores a value that is not stored, of which the next greater one is known.
    ///
    /// Computes in **O(log₆₄ universe)** time, and **O(1)** where the set is dense.
    #[inline]
    pub(super) fn insert_before(&mut self, next: u32, value: u32, label: u32) {
        let prev = core::mem::replace(&mut self.nodes[next as usize].prev, value);
        debug_assert!(prev == self.bits.universe() || prev < value);
        self.nodes[prev as usize].next = value;
        self.nodes[value as usize] = Node { next, prev, label };
        self.bits.insert(value);
    }

    /// Removes a stored value.
    ///
    /// Computes in **O(log₆₄ universe)** time, and **O(1)** where the set is dense.
    #[inline]
    pub(super) fn remove(&mut self, value: u32) {
        let Node { next, prev, .. } = self.nodes[value as usize];
        self.nodes[next as usize].prev = prev;
        self.nodes[prev as usize].next = next;
        self.bits.remove(value);
    }
}
