//! The plan on both sides of each threshold.

use super::*;

/// Whether a full search is due in a world of 1000 slots and 4000 candidates.
fn is_due(cost: Cost, recent: usize, leavers: u64) -> bool {
    cost.is_full_search_due(recent, [leavers as usize, 1000, 4000])
}

/// The costs after a full search at the usual price and so many updates, that one included.
fn searched(updates: u64) -> Cost {
    Cost {
        updates,
        searching: FULL_SEARCH,
        ..Cost::default()
    }
}

/// The cost of a full search in this world.
const FULL_SEARCH: u64 = 1000 * SEARCHED + 4000 * FOUND;

/// The share of it that look-ups may cost beyond the mean.
const TOLERANCE: u64 = FULL_SEARCH / FULL_SEARCH_TOLERANCE_ONE_IN;

/// The cost of a look-up where no slot is recent: it finds the share of both its ends in four candidates per slot.
const LOOK_UP: u64 = LOOKED_UP + SEARCHED + 8 * FOUND;

#[test]
fn all_slots_are_visited_from_one_in_three_on() {
    assert!(are_many_touched(333, 1000) && !are_many_touched(332, 1000));
}

#[test]
fn look_ups_may_cost_as_much_as_the_mean_since_the_last_full_search() {
    for updates in [1, 2, 10, 1000] {
        // The recent slots are searched as well.
        for recent in [0, 8] {
            let cost = searched(updates);
            let most = (FULL_SEARCH / updates + TOLERANCE - recent as u64 * SEARCHED) / LOOK_UP;
            assert!(!is_due(cost, recent, most) && is_due(cost, recent, most + 1));
        }
    }
}

#[test]
fn a_full_search_is_due_once_the_layers_have_cost_as_much() {
    let above = |recent| Cost {
        recent,
        ..searched(1)
    };
    assert!(!is_due(above(1000), 0, 1) && is_due(above(1001), 0, 1));
}

#[test]
fn costs_add_up_and_end_at_the_largest_number() {
    let mut work = Work::default();
    (work.looked_up, work.searched, work.found) = (1000, 10_000, 100_000);
    let mut cost = Cost::default();
    cost.add(&work);
    cost.add(&Work::default());
    let searching = 1000 * LOOKED_UP + 10_000 * SEARCHED + 100_000 * FOUND;
    assert_eq!((cost.updates, cost.searching), (2, searching));
    // Where a count has 32 bits, no single one costs as much.
    (work.found, cost.searching) = (usize::MAX, u64::MAX - 1);
    cost.add(&work);
    assert_eq!((cost.searching, cost.recent), (u64::MAX, 20_000));
    cost.recent = 0;
    assert!(!is_due(cost, 0, 1));
}
