//! What an update does: a function from a few numbers to a plan.
//!
//! Comparing boxes that are known to be near each other is cheap. Looking a few boxes up among all others costs more. A full search, a
//! search for all pairs, costs most, and postpones the next one. The prices are in `tuning`.

#[cfg(test)]
mod tests;

use super::foresight::Foresight;
use crate::tuning::prices::{FOUND, LOOKED_UP, SEARCHED, VISITED};

/// One slot in this many. If more were touched, an update goes through all slots and all candidates, in order; otherwise only through the
/// touched slots, and it picks their candidates. If larger: all candidates are compared though few can have changed. If smaller: picking
/// costs as much as comparing.
const COMPARE_ALL_FROM_ONE_IN: usize = 3;

/// A share of a full search. There is one if the look-ups of an update cost more by this than the mean of all updates since the last full
/// search, that one included. If larger: waves, fat boxes made at one time and left at one time, are looked up box by box. If smaller: full
/// searches by chance.
const FULL_SEARCH_TOLERANCE: u64 = 16;

/// What decides the plan of an update.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlanInputs {
    /// Slots for which there is room.
    pub(super) slots: usize,
    /// Slots whose boxes have left their fat boxes, are new, or are gone.
    pub(super) leavers: usize,
    pub(super) candidates: usize,
    /// Slots in the recent layer, if leavers may be looked up.
    pub(super) recent: Option<usize>,
    /// How far ahead the present fat boxes reach.
    pub(super) foresight: Foresight,
    /// The cost of searching in all updates since the last full search, that one included.
    pub(super) cost: Cost,
}

/// What an update does that has something to do.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Plan {
    /// No box has left its fat box: compare candidates.
    Compare,
    /// A few boxes have: look them up in the layers, then compare candidates.
    LookUp,
    /// Many boxes have, or are about to: make new fat boxes with this foresight for all that have moved, and search for all pairs.
    FullSearch(Foresight),
}

impl Plan {
    /// The plan for an update. `mean_speed`, that of the proxies that have moved, in box sizes per move, is called only before a full
    /// search.
    pub(super) fn of(inputs: &PlanInputs, mean_speed: impl FnOnce() -> Option<f64>) -> Self {
        if inputs.leavers == 0 {
            Self::Compare
        } else if inputs.is_full_search_due() {
            Self::FullSearch(inputs.foresight.renewed(mean_speed))
        } else {
            Self::LookUp
        }
    }
}

impl PlanInputs {
    fn is_full_search_due(&self) -> bool {
        let Some(recent) = self.recent else {
            return true;
        };
        let counts = [recent, self.leavers, self.slots, self.candidates];
        let [recent, leavers, slots, found] = counts.map(|count| count as u64);
        let full_search = SEARCHED * slots + FOUND * found;
        // Each finds all candidates of its own, which are those of another as well.
        let found_by_look_ups = found.min(found.saturating_mul(2 * leavers) / slots);
        let look_up =
            LOOKED_UP.saturating_add(VISITED.saturating_mul(self.cost.visits_a_look_up()));
        let look_ups = look_up
            .saturating_mul(leavers)
            .saturating_add(SEARCHED * (recent + leavers) + FOUND * found_by_look_ups);
        // As long as an update costs less than the mean since the last full search, that search still pays. Fat boxes made at one time
        // tend to be left at one time; then it no longer does.
        let tolerated = full_search / FULL_SEARCH_TOLERANCE;
        look_ups > self.cost.mean().saturating_add(tolerated) || self.cost.recent > slots
    }
}

/// The work of an update's searches, in counts of operations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Work {
    /// Boxes that were looked up among all others.
    pub(super) looked_up: usize,
    /// Boxes with which these were compared, and the cost of finding them, in comparisons.
    pub(super) visited: usize,
    /// Boxes among which all pairs were searched for.
    pub(super) searched: usize,
    /// Pairs that were found by either.
    pub(super) found: usize,
}

/// The cost of searching in some updates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Cost {
    updates: u64,
    searching: u64,
    /// Look-ups, their visits, and the boxes of the searches of the recent layer.
    looked_up: u64,
    visited: u64,
    recent: u64,
}

impl Cost {
    /// Adds an update.
    pub(super) fn add(&mut self, work: &Work) {
        let counts = [
            (work.looked_up, LOOKED_UP),
            (work.visited, VISITED),
            (work.searched, SEARCHED),
            (work.found, FOUND),
        ];
        self.updates = self.updates.saturating_add(1);
        for (count, cost) in counts {
            let cost = cost.saturating_mul(count as u64);
            self.searching = self.searching.saturating_add(cost);
        }
        if work.looked_up > 0 {
            self.looked_up = self.looked_up.saturating_add(work.looked_up as u64);
            self.visited = self.visited.saturating_add(work.visited as u64);
            self.recent = self.recent.saturating_add(work.searched as u64);
        }
    }

    /// The cost of an update, on average; 0 if there was none.
    pub(super) fn mean(&self) -> u64 {
        self.searching / self.updates.max(1)
    }

    /// The visits of a look-up, on average; 0 if there was none.
    fn visits_a_look_up(&self) -> u64 {
        self.visited / self.looked_up.max(1)
    }
}

/// Whether going through all slots in order is faster than visiting those that were touched.
pub(super) fn are_most_touched(touched: usize, slots: usize) -> bool {
    touched >= slots / COMPARE_ALL_FROM_ONE_IN
}
