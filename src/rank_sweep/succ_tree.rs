//! The active set: a set of small integers that knows its order.
//!
//! The paper's SuccTree: a tree of bits, which finds the neighbour of a value, and the stored values linked in order as
//! well (section 4 of the paper), so that walking from one to the next is a single step, however far apart they are.

use crate::bit_tree::BitTree;

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

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    impl SuccTree {
        /// The greatest stored value less than `value`, or the universe's size: the links spare a search downward.
        fn predecessor(&self, value: u32) -> u32 {
            if self.bits.contains(value) {
                self.nodes[value as usize].prev
            } else {
                self.nodes[self.bits.successor(value) as usize].prev
            }
        }

        /// Compares everything with a set of the standard library.
        fn check(&self, expected: &BTreeSet<u32>) {
            let mut walked = Vec::new();
            let universe = self.bits.universe();
            let mut at = self.next(universe);
            while at != universe {
                assert_eq!(self.label(at), !at);
                walked.push(at);
                at = self.next(at);
            }
            assert!(walked.iter().eq(expected));
            let mut at = self.nodes[universe as usize].prev;
            for &value in walked.iter().rev() {
                assert_eq!(at, value);
                at = self.nodes[at as usize].prev;
            }
            assert_eq!(at, universe);
            self.bits.check(expected);
        }

        fn check_neighbours(&self, expected: &BTreeSet<u32>, value: u32) {
            let predecessor = expected.range(..value).next_back();
            let universe = self.bits.universe();
            self.bits.check_neighbour(expected, value);
            assert_eq!(self.predecessor(value), *predecessor.unwrap_or(&universe));
        }
    }

    /// Stores and removes random values; growing and shrinking take turns.
    fn exercise(tree: &mut SuccTree, universe: u32, steps: u32, random: &mut oorandom::Rand32) {
        let mut expected = BTreeSet::new();
        tree.reset(universe);
        tree.check(&expected);
        if universe == 0 {
            return;
        }
        for step in 0..steps {
            let value = random.rand_range(0..universe);
            tree.check_neighbours(&expected, value);
            let grow = random.rand_range(0..8) < if step & 512 == 0 { 7 } else { 1 };
            if grow && expected.insert(value) {
                let next = *expected.range(value + 1..).next().unwrap_or(&universe);
                if step & 1 == 0 {
                    assert_eq!(tree.insert(value, !value), next);
                } else {
                    tree.insert_before(next, value, !value);
                }
            } else if !grow {
                // The nearest stored one, because a random value is hardly ever stored in a large universe.
                let nearest = expected.range(value..).next().copied();
                if let Some(value) = nearest {
                    expected.remove(&value);
                    tree.remove(value);
                }
            }
        }
        tree.check(&expected);
        for end in [0, universe - 1] {
            tree.check_neighbours(&expected, end);
        }
    }

    #[test]
    fn agrees_with_a_btree_set() {
        let mut random = oorandom::Rand32::new(1);
        let mut tree = SuccTree::default();
        for universe in 0..=260 {
            exercise(&mut tree, universe, 600, &mut random);
        }
        for power in [64_u32, 64 * 64, 64 * 64 * 64] {
            for universe in power - 2..=power + 2 {
                exercise(&mut tree, universe, 5000, &mut random);
                exercise(&mut tree, 2 * universe, 2000, &mut random);
            }
        }
    }

    #[test]
    fn a_full_set_fills_and_empties_in_any_direction() {
        let mut tree = SuccTree::default();
        for universe in [1, 63, 64, 65, 4095, 4096, 4097, 5000] {
            tree.reset(universe);
            for value in (0..universe).rev() {
                tree.insert(value, !value);
            }
            tree.check(&(0..universe).collect());
            for value in 0..universe {
                tree.remove(value);
            }
            tree.check(&BTreeSet::new());
        }
    }
}
