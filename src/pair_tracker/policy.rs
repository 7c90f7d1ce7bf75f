//! What an update does: a function from a few numbers to a plan.
//!
//! Comparing boxes that are known to be near each other is cheap. Looking a few boxes up among all others costs more. A
//! full search, a search for all pairs, costs most, but it postpones the next ones. The costs are in `tuning`.

#[cfg(test)]
mod tests;

use super::foresight::Foresight;
use super::layers::AboveBase;
use crate::stats::Work;
use crate::tuning::prices::{FOUND, LISTED, LOOKED_UP, PICKED, SEARCHED, VISITED, WALKED};
use crate::tuning::update::{
    COMPARE_ALL_FROM_ONE_IN, FULL_SEARCH_SLACK, LISTS_COST, MOST_CANDIDATES,
};

/// What decides the plan of an update.
#[derive(Clone, Copy, Debug)]
pub(super) struct PlanInputs {
    /// Slots there is room for.
    pub(super) slots: usize,
    /// Slots that were touched: their boxes or keys were written. A slot may count more than once.
    pub(super) touched: usize,
    /// Slots whose volume has changed, and not their box. May count more than once, and may have been touched as well.
    pub(super) revolumed: usize,
    /// Touched slots whose boxes have left their fat boxes, have none yet, or are gone.
    pub(super) leavers: usize,
    pub(super) candidates: usize,
    /// Rows of the candidates, tombstones included.
    pub(super) rows: usize,
    pub(super) lists: ListState,
    /// What is above the base layer, if leavers may be looked up in it.
    pub(super) above_base: Option<AboveBase>,
    /// How far ahead the present fat boxes reach.
    pub(super) foresight: Foresight,
    /// What searching has cost in all updates since the last full search, that run included.
    pub(super) cost: Cost,
}

/// What an update does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Plan {
    /// Nothing was touched.
    Nothing,
    /// Nothing has left its fat box: candidates are compared.
    Compare(CompareMode),
    /// Little has: it is looked up in the layers, then candidates are compared.
    LookUp(CompareMode),
    /// Much has, or is about to: what has moved is inflated anew with this foresight, and all pairs are searched for.
    FullSearch(Foresight),
}

/// Which candidates are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CompareMode {
    /// All, in order.
    All,
    /// Those of the touched slots, picked from all. `lists_are_missed` if lists would have been useful.
    Picked { lists_are_missed: bool },
    /// Those of the touched slots, by lists, which are made if there are none.
    Listed,
}

/// Whether there are lists of the candidates of each slot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct ListState {
    pub(super) are_made: bool,
    /// How often they would have been useful while there were none.
    pub(super) missed: u32,
}

impl ListState {
    /// The most rows that 32-bit links can tell apart.
    pub(super) const MOST_ROWS: usize = 1 << 30;

    /// Whether walking the lists of some of all slots is cheaper than picking their candidates from all rows.
    pub(super) fn pay(self, walked: usize, slots: usize, rows: usize) -> bool {
        let [listed, slots, all] = [walked, slots, rows].map(to_u64);
        // Each candidate is in two lists.
        let candidates = 2 * all * listed / slots.max(1);
        LISTED * listed + WALKED * candidates < PICKED * all && rows <= Self::MOST_ROWS
    }

    /// Whether they have been missed often enough to be made.
    pub(super) fn are_due(self) -> bool {
        self.missed >= LISTS_COST
    }
}

impl Plan {
    /// The plan for an update. `mean_speed`, of what has moved, in box sizes per move, is called only before a full search.
    pub(super) fn of(inputs: &PlanInputs, mean_speed: impl FnOnce() -> Option<f64>) -> Self {
        if inputs.touched + inputs.revolumed == 0 {
            return Self::Nothing;
        }
        if inputs.is_full_search_due() {
            return Self::FullSearch(inputs.foresight.renewed(mean_speed));
        }
        let mode = inputs.compare_mode();
        match inputs.leavers {
            0 => Self::Compare(mode),
            _ => Self::LookUp(mode),
        }
    }
}

impl PlanInputs {
    fn is_full_search_due(&self) -> bool {
        if self.leavers == 0 {
            return false;
        }
        let Some(above_base) = self.above_base else {
            return true;
        };
        let [leavers, slots, found] = [self.leavers, self.slots, self.candidates].map(to_u64);
        let full_search = SEARCHED * slots + FOUND * found;
        // Each finds all candidates of its own, which are those of another as well.
        let found_by_look_ups = found.min(found.saturating_mul(2 * leavers) / slots);
        let look_up =
            LOOKED_UP.saturating_add(VISITED.saturating_mul(self.cost.visits_a_look_up()));
        let look_ups = look_up.saturating_mul(leavers).saturating_add(
            SEARCHED * (to_u64(above_base.recent) + leavers) + FOUND * found_by_look_ups,
        );
        // As long as an update costs less than the mean since the last full search, that run still pays. Fat boxes made
        // at one time tend to be left at one time; then it no longer does.
        let mean = self.cost.searching / self.cost.updates.max(1);
        look_ups > mean.saturating_add(full_search / FULL_SEARCH_SLACK)
            || above_base.cost > self.slots
    }

    fn compare_mode(&self) -> CompareMode {
        if are_most_touched(self.touched, self.slots) {
            return CompareMode::All;
        }
        let lists = self.lists;
        let pay = lists.pay(self.touched, self.slots, self.rows);
        match pay && (lists.are_made || lists.are_due()) {
            true => CompareMode::Listed,
            false => CompareMode::Picked {
                lists_are_missed: pay,
            },
        }
    }
}

/// What searching has cost in some updates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Cost {
    pub(super) updates: u64,
    pub(super) searching: u64,
    /// Of that, look-ups and what they visited.
    pub(super) looked_up: u64,
    pub(super) visited: u64,
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
            let cost = cost.saturating_mul(to_u64(count));
            self.searching = self.searching.saturating_add(cost);
        }
        self.looked_up = self.looked_up.saturating_add(to_u64(work.looked_up));
        self.visited = self.visited.saturating_add(to_u64(work.visited));
    }

    /// What a look-up has visited, on average; nothing if there was none.
    fn visits_a_look_up(&self) -> u64 {
        self.visited / self.looked_up.max(1)
    }
}

/// Whether so many slots were touched that going through all slots in order is faster than visiting only the touched.
pub(super) fn are_most_touched(touched: usize, slots: usize) -> bool {
    touched >= slots / COMPARE_ALL_FROM_ONE_IN
}

fn to_u64(count: usize) -> u64 {
    count as u64
}

/// Whether there are more candidates than foresight can be worth.
pub(super) fn are_too_many(candidates: usize, slots: usize, overlapping: usize) -> bool {
    candidates / MOST_CANDIDATES > slots + overlapping
}
