//! Whether an update looks leavers up or searches for all pairs: a function of a few numbers.
//!
//! Looking up costs more than comparing candidates. A full search costs most, and postpones the next one. The prices are in `tuning`.

use crate::tuning::prices::{FOUND, LOOKED_UP, SEARCHED, VISITED};

/// One slot in this many. If as many were touched, an update goes through all slots and all candidates, in order; otherwise only through the
/// touched slots, and it picks their candidates. If larger: all candidates are compared though few can have changed. If smaller: picking
/// costs as much as comparing.
const IN_ORDER_FROM_ONE_IN: usize = 3;

/// One part in this many of the cost of a full search. An update searches in full if its look-ups cost more by this part than the mean of all
/// updates since the last full search, that one included. If larger: full searches by chance. If smaller: fat boxes that were made at one
/// time, and that their boxes leave at one time, are looked up one by one.
const FULL_SEARCH_TOLERANCE_ONE_IN: u64 = 16;

/// The work of searches, in counts of operations: of one update, or of all since the last full search, that one included.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Work {
    /// The updates that were added.
    pub(super) updates: u64,
    /// Boxes that were looked up among all others.
    pub(super) looked_up: u64,
    /// Boxes with which these were compared, and the cost of finding them, in comparisons.
    pub(super) visited: u64,
    /// Boxes of the recent layer, among which pairs were searched for.
    pub(super) recent: u64,
    /// Boxes of full searches.
    pub(super) searched: u64,
    /// Pairs that were found.
    pub(super) found: u64,
}

impl Work {
    /// Adds that of an update.
    pub(super) fn add(&mut self, update: &Self) {
        self.updates += 1;
        self.looked_up += update.looked_up;
        self.visited += update.visited;
        self.recent += update.recent;
        self.searched += update.searched;
        self.found += update.found;
    }

    /// Whether an update searches for all pairs, given how many slots are in the recent layer, how many are leavers, how many there is room
    /// for, and the number of candidates. The same numbers give the same answer on every machine.
    pub(super) fn is_full_search_due(&self, recent: usize, counts: [usize; 3]) -> bool {
        let [leavers, slots, found] = counts.map(|count| count as u64);
        let full_search = SEARCHED * slots + FOUND * found;
        // Each finds all of its candidates, and each of these belongs to another slot as well.
        let found_by_look_ups = found.min(found.saturating_mul(2 * leavers) / slots);
        let look_up = LOOKED_UP + VISITED * (self.visited / self.looked_up.max(1));
        let others = SEARCHED * (recent as u64 + leavers) + FOUND * found_by_look_ups;
        // This is work that is not done yet.
        let look_ups = look_up.saturating_mul(leavers).saturating_add(others);
        // As long as an update costs less than the mean since the last full search, that search still pays. Fat boxes made at one time
        // tend to be left at one time; then it no longer does.
        let tolerated = full_search / FULL_SEARCH_TOLERANCE_ONE_IN;
        look_ups > self.mean() + tolerated || self.recent > slots
    }

    /// The cost of an update, on average; 0 if there was none. It does not overflow: this is work that was done, in tenths of a nanosecond, of
    /// which 2⁶⁴ are 58 years.
    pub(super) fn mean(&self) -> u64 {
        let looked_up = LOOKED_UP * self.looked_up + VISITED * self.visited;
        let searched = SEARCHED * (self.recent + self.searched) + FOUND * self.found;
        (looked_up + searched) / self.updates.max(1)
    }
}

/// Whether so many slots were touched, repeats included, that going through all slots in order is faster than visiting these.
pub(super) fn are_many_touched(touched: usize, slots: usize) -> bool {
    touched >= slots / IN_ORDER_FROM_ONE_IN
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_full_search_is_due_once_the_layers_or_look_ups_cost_as_much() {
        let cost = |recent, visited| Work {
            updates: 1,
            looked_up: 1,
            visited,
            recent,
            searched: 1000,
            found: 4000,
        };
        let is_due = |cost: Work, leavers| cost.is_full_search_due(0, [leavers, 1000, 4000]);
        assert!(!is_due(cost(1000, 0), 1) && is_due(cost(1001, 0), 1));
        assert!(!is_due(cost(0, 0), 200) && is_due(cost(0, 0), 400));
        // Each look-up visits everything, and all slots have left.
        let slots = 1 << 29;
        assert!(cost(0, 86 << 29).is_full_search_due(0, [slots, slots, 0]));
    }
}
