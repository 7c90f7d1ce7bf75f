//! Active intervals of about one length, and which of them overlap another.

use crate::bit_tree::BitTree;

/// How many classes there are: lengths are between two ranks, so they are positive and of 32 bits.
pub(super) const CLASSES: usize = 32;

/// The class of a length: in each, all are less than twice as long as any.
#[inline]
pub(super) fn class_of(length: u32) -> usize {
    length.ilog2() as usize
}

/// Intervals between two ranks, of which none is twice as long as another. No rank is that of two endpoints, nor 0.
#[derive(Clone, Debug, Default)]
pub(super) struct LengthClass {
    /// The ranks of the active low endpoints.
    lows: BitTree,
    /// The ranks of the active high endpoints.
    highs: BitTree,
    /// The least and the greatest length that may come; no length at all if the least is the greater.
    shortest: u32,
    longest: u32,
    /// How many intervals are active.
    active: u32,
}

impl LengthClass {
    /// Forgets what lengths may come.
    pub(super) fn clear(&mut self) {
        (self.shortest, self.longest) = (u32::MAX, 0);
    }

    /// Lets intervals of this length come.
    #[inline]
    pub(super) fn admit(&mut self, length: u32) {
        self.shortest = self.shortest.min(length);
        self.longest = self.longest.max(length);
    }

    /// Makes room for ranks up to `greatest`, if intervals may come at all.
    pub(super) fn reset(&mut self, greatest: u32) {
        self.active = 0;
        if self.shortest <= self.longest {
            self.lows.reset(greatest + 1);
            self.highs.reset(greatest + 1);
        }
    }

    /// Adds an interval, and returns whether it is the only one.
    #[inline]
    pub(super) fn insert(&mut self, [low, high]: [u32; 2]) -> bool {
        self.lows.insert(low);
        self.highs.insert(high);
        self.active += 1;
        self.active == 1
    }

    /// Takes out an interval, and returns whether it was the only one.
    #[inline]
    pub(super) fn remove(&mut self, [low, high]: [u32; 2]) -> bool {
        self.lows.remove(low);
        self.highs.remove(high);
        self.active -= 1;
        self.active == 0
    }

    /// Calls `found` with the low rank of each active interval that overlaps this one and begins after
    /// [`earliest`](Self::earliest).
    #[inline]
    pub(super) fn beginning(&self, [low, high]: [u32; 2], mut found: impl FnMut(u32)) {
        let mut rank = self.lows.successor(self.earliest(low));
        while rank < high {
            found(rank);
            rank = self.lows.successor(rank);
        }
    }

    /// Calls `found` with the high rank of each active interval that overlaps one from `low` on and does not begin after
    /// [`earliest`](Self::earliest), and of some that do.
    #[inline]
    pub(super) fn ending(&self, low: u32, mut found: impl FnMut(u32)) {
        let earliest = self.earliest(low);
        if earliest == 0 {
            // Nothing begins so early.
            return;
        }
        // What does, does not reach farther than this, and what ends up to there begins before `low`.
        let latest = earliest.saturating_add(self.longest);
        if latest <= low {
            return;
        }
        let mut rank = self.highs.successor(low);
        while rank <= latest && rank < self.highs.universe() {
            found(rank);
            rank = self.highs.successor(rank);
        }
    }

    /// What begins after this, and before `low`, reaches `low`: it is longer than the distance.
    #[inline]
    pub(super) fn earliest(&self, low: u32) -> u32 {
        low.saturating_sub(self.shortest)
    }
}
