//! The plan on both sides of each threshold.

use super::*;

/// A world of 1000 slots and 4000 candidates, after a full search at the usual price, with this number of leavers.
fn left(leavers: u64) -> PlanInputs {
    PlanInputs {
        slots: 1000,
        leavers: leavers as usize,
        candidates: 4000,
        recent: Some(0),
        foresight: Foresight::new(None),
        cost: Cost {
            updates: 1,
            searching: FULL_SEARCH,
            ..Cost::default()
        },
    }
}

/// The cost of a full search in this world.
const FULL_SEARCH: u64 = 1000 * SEARCHED + 4000 * FOUND;

/// The share of it that look-ups may cost beyond the mean.
const TOLERANCE: u64 = FULL_SEARCH / FULL_SEARCH_TOLERANCE;

/// The cost of a look-up where no slot is recent: it finds the share of both its ends in four candidates per slot.
const LOOK_UP: u64 = LOOKED_UP + SEARCHED + 8 * FOUND;

fn plan(inputs: PlanInputs) -> Plan {
    Plan::of(&inputs, || Some(0.1))
}

fn is_full_search(inputs: PlanInputs) -> bool {
    matches!(plan(inputs), Plan::FullSearch(_))
}

#[test]
fn all_slots_are_visited_from_one_in_three_on() {
    assert!(are_most_touched(333, 1000) && !are_most_touched(332, 1000));
}

#[test]
fn look_ups_may_cost_as_much_as_the_mean_since_the_last_full_search() {
    for updates in [1, 2, 10, 1000] {
        // The recent slots are searched as well.
        for recent in [0, 8] {
            let searched = |leavers| {
                let mut inputs = left(leavers);
                inputs.recent = Some(recent);
                inputs.cost.updates = updates;
                inputs
            };
            let most = (FULL_SEARCH / updates + TOLERANCE - recent as u64 * SEARCHED) / LOOK_UP;
            assert_eq!(plan(searched(most)), Plan::LookUp);
            assert!(is_full_search(searched(most + 1)));
        }
    }
}

#[test]
fn a_full_search_is_due_once_the_layers_have_cost_as_much() {
    let above = |recent, leavers| {
        let mut inputs = left(leavers);
        inputs.cost.recent = recent;
        inputs
    };
    assert!(!is_full_search(above(1000, 1)) && is_full_search(above(1001, 1)));
    // It can wait until a box has left its fat box.
    assert_eq!(plan(above(1001, 0)), Plan::Compare);
}

#[test]
fn without_a_base_layer_every_search_is_a_full_search() {
    for leavers in [0, 1] {
        let mut inputs = left(leavers);
        inputs.recent = None;
        assert_eq!(is_full_search(inputs), leavers > 0);
    }
}

#[test]
fn a_fixed_foresight_stays_and_others_follow_the_speed() {
    for (fixed, moves) in [(Some(7), 7), (None, 5)] {
        let mut inputs = left(1000);
        inputs.foresight = Foresight::new(fixed);
        assert!(matches!(plan(inputs), Plan::FullSearch(renewed) if renewed.moves == moves));
    }
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
    assert!(!is_full_search(PlanInputs { cost, ..left(1) }));
}
