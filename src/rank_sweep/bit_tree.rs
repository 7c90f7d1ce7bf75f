//! A set of small integers, one bit each, that finds the neighbour of a value.
//!
//! A perfect 64-ary tree with one bit per node: a bit of the lowest level says that a value is stored, a bit of a higher
//! one that at least one value is stored below it. The 64 children of a node are one machine word, so the neighbour of a
//! value is found with a few shifts and bit scans per level, and there are few levels: four for two million values. This
//! is the tree of Capannini and Larsson, *Efficient collision culling by a succinct bi-dimensional sweep and prune
//! algorithm* (2016).

/// Bits of a value that one level decides.
const LEVEL_BITS: u32 = 6;
/// Enough for every `u32`.
const MAX_LEVELS: usize = 6;

/// A set of values below a bound, its *universe*.
#[derive(Clone, Debug, Default)]
pub(super) struct BitTree {
    /// The bits of all levels, the lowest first.
    words: Vec<u64>,
    /// Where in `words` each level starts.
    starts: [usize; MAX_LEVELS],
    /// How many levels there are; the highest is one word.
    levels: usize,
    /// Values are below this, which also stands for "none".
    universe: u32,
}

impl BitTree {
    /// Empties the set and makes room for the values below `universe`.
    ///
    /// Computes in **O(universe / 64)** time.
    pub(super) fn reset(&mut self, universe: u32) {
        let mut total = 0;
        let mut width = universe as usize;
        self.levels = 0;
        while self.levels == 0 || width > 1 {
            width = width.div_ceil(1 << LEVEL_BITS).max(1);
            self.starts[self.levels] = total;
            self.levels += 1;
            total += width;
        }
        self.words.clear();
        self.words.resize(total, 0);
        self.universe = universe;
    }

    /// The bound of the values, which also stands for "none".
    #[inline]
    pub(super) fn universe(&self) -> u32 {
        self.universe
    }

    /// Stores a value.
    ///
    /// Computes in **O(log₆₄ universe)** time, and **O(1)** where the set is dense.
    #[inline]
    pub(super) fn insert(&mut self, value: u32) {
        let mut at = value as usize;
        for level in 0..self.levels {
            let word = &mut self.words[self.starts[level] + (at >> LEVEL_BITS)];
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
        let mut at = value as usize;
        for level in 0..self.levels {
            let word = &mut self.words[self.starts[level] + (at >> LEVEL_BITS)];
            *word &= !(1 << (at & 63));
            if *word != 0 {
                break;
            }
            at >>= LEVEL_BITS;
        }
    }

    /// The least stored value greater than `value`, or the universe's size if there is none; `value` need not be stored.
    ///
    /// Computes in **O(log₆₄ universe)** time.
    #[inline]
    pub(super) fn successor(&self, value: u32) -> u32 {
        let mut at = value as usize;
        for level in 0..self.levels {
            let word = self.words[self.starts[level] + (at >> LEVEL_BITS)];
            // Shifted in two steps: shifting by 64 is not defined.
            let above = word & (!0 << (at & 63) << 1);
            if above != 0 {
                at = at & !63 | above.trailing_zeros() as usize;
                for below in (0..level).rev() {
                    let word = self.words[self.starts[below] + at];
                    at = at << LEVEL_BITS | word.trailing_zeros() as usize;
                }
                return at as u32;
            }
            at >>= LEVEL_BITS;
        }
        self.universe
    }
}
