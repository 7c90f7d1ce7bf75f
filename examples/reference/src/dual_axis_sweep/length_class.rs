//! Active intervals of about one length, and which of them overlap a given one.

use crate::bit_tree::BitTree;

/// The number of classes: a length is the difference of two ranks, so it is positive and has 32 bits.
pub(super) const CLASSES: usize = 32;

/// The class of a length. In each class, every length is less than twice any other.
#[inline]
pub(super) fn class_of(length: u32) -> usize {
    length.ilog2() as usize
}

/// Intervals between two ranks, none of which is twice as long as another. No two endpoints have the same rank, and none
/// has rank 0.
#[derive(Clone, Debug, Default)]
pub(super) struct LengthClass {
    /// The ranks of the active low endpoints.
    lows: BitTree,
    /// The ranks of the active high endpoints.
    highs: BitTree,
    /// The least and the greatest length that may be inserted; if the least is the greater, none may.
    shortest: u32,
    longest: u32,
    /// How many intervals are active.
    active: u32,
}

impl LengthClass {
    /// Forgets which lengths may be inserted.
    pub(super) fn clear(&mut self) {
        (self.shortest, self.longest) = (u32::MAX, 0);
    }

    /// Lets intervals of this length be inserted.
    #[inline]
    pub(super) fn admit(&mut self, length: u32) {
        self.shortest = self.shortest.min(length);
        self.longest = self.longest.max(length);
    }

    /// Makes room for ranks up to `greatest`, if any interval may be inserted.
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

    /// Removes an interval, and returns whether it was the only one.
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
    /// [`earliest`](Self::earliest). Some that do begin after it are found too.
    #[inline]
    pub(super) fn ending(&self, low: u32, mut found: impl FnMut(u32)) {
        let earliest = self.earliest(low);
        if earliest == 0 {
            // Nothing begins so early.
            return;
        }
        // An interval that begins so early ends here at the latest, and one that ends here or earlier begins before
        // `low`.
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

    /// An interval that begins after this, and before `low`, reaches `low`: it is longer than the distance.
    #[inline]
    pub(super) fn earliest(&self, low: u32) -> u32 {
        low.saturating_sub(self.shortest)
    }
}
