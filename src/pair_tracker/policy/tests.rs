//! The plan at every border between one decision and another.

use super::*;

/// A world of 1000 slots at rest, with lists out of date, and one full search that has cost as much as one does.
fn world() -> PlanInputs {
    PlanInputs {
        slots: 1000,
        touched: 0,
        revolumed: 0,
        leavers: 0,
        candidates: 4000,
        rows: 5000,
        lists: ListState::default(),
        above_base: Some(AboveBase::default()),
        foresight: Foresight::new(None),
        cost: Cost {
            updates: 1,
            searching: FULL_SEARCH,
            ..Cost::default()
        },
    }
}

/// The world, with this number of leavers.
fn left(leavers: u64) -> PlanInputs {
    PlanInputs {
        touched: 500,
        leavers: leavers as usize,
        ..world()
    }
}

/// What a full search costs in this world.
const FULL_SEARCH: u64 = 1000 * SEARCHED + 4000 * FOUND;

/// The part of it that look-ups may cost beyond the mean.
const SLACK: u64 = FULL_SEARCH / FULL_SEARCH_SLACK;

/// What it costs more to look one up than not to, with none in the upper layers: it finds both ends' share of four
/// candidates a slot.
const LOOK_UP: u64 = LOOKED_UP + SEARCHED + 8 * FOUND;

const BY_LISTS: Plan = Plan::Compare(CompareMode::Listed);

/// Candidates are picked, whether lists are missed or not.
fn picked(lists_are_missed: bool) -> Plan {
    Plan::Compare(CompareMode::Picked { lists_are_missed })
}

fn plan(inputs: PlanInputs) -> Plan {
    Plan::of(&inputs, || Some(0.1))
}

fn is_full_search(inputs: PlanInputs) -> bool {
    matches!(plan(inputs), Plan::FullSearch(_))
}

#[test]
fn candidates_are_compared_as_far_as_slots_were_touched() {
    // Walking the lists of 20 slots, with their share of the rows, is worth picking from more rows than this.
    let rows = (20 * LISTED * 1000 / (1000 * PICKED - 2 * 20 * WALKED)) as usize;
    // There are so many in the lists of as many slots as this that it never is.
    let many = (1000 * PICKED / (2 * WALKED)) as usize;
    for (touched, rows, expected) in [
        (333, 5000, Plan::Compare(CompareMode::All)),
        (332, 5000, picked(false)),
        (20, rows + 1, picked(true)),
        (20, rows, picked(false)),
        (many, 1 << 30, picked(false)),
    ] {
        // What has another volume changes nothing about it.
        for revolumed in [0, 500] {
            let world = world();
            let inputs = PlanInputs {
                touched,
                rows,
                revolumed,
                ..world
            };
            assert_eq!(plan(inputs), expected);
        }
    }
    assert_eq!(plan(world()), Plan::Nothing);
}

#[test]
fn lists_are_made_once_they_were_missed_often_enough() {
    for (are_made, missed, rows, expected) in [
        (false, LISTS_COST - 1, 5000, picked(true)),
        (false, LISTS_COST, 5000, BY_LISTS),
        (true, 0, 5000, BY_LISTS),
        // Links could not tell more apart.
        (true, 8, ListState::MOST_ROWS, BY_LISTS),
        (true, 8, ListState::MOST_ROWS + 1, picked(false)),
    ] {
        let (world, lists) = (world(), ListState { are_made, missed });
        let inputs = PlanInputs {
            touched: 1,
            lists,
            rows,
            ..world
        };
        assert_eq!(plan(inputs), expected);
    }
}

#[test]
fn look_ups_may_cost_as_much_as_the_mean_since_the_last_full_search() {
    for updates in [1, 2, 10, 1000] {
        // What is recent is searched as well.
        for recent in [0, 8] {
            let searched = |leavers| {
                let mut inputs = left(leavers);
                inputs.above_base = Some(AboveBase { recent, cost: 0 });
                inputs.cost.updates = updates;
                inputs
            };
            let most = (FULL_SEARCH / updates + SLACK - recent as u64 * SEARCHED) / LOOK_UP;
            assert_eq!(plan(searched(most)), Plan::LookUp(CompareMode::All));
            assert!(is_full_search(searched(most + 1)));
        }
    }
}

#[test]
fn a_full_search_is_due_once_the_layers_have_cost_as_much() {
    let above = |cost, leavers| PlanInputs {
        above_base: Some(AboveBase { cost, recent: 0 }),
        ..left(leavers)
    };
    assert!(!is_full_search(above(1000, 1)) && is_full_search(above(1001, 1)));
    // It can wait until something has left.
    assert_eq!(plan(above(1001, 0)), Plan::Compare(CompareMode::All));
}

#[test]
fn without_a_base_layer_every_search_is_a_full_search() {
    for leavers in [0, 1] {
        let mut inputs = left(leavers);
        inputs.above_base = None;
        assert_eq!(is_full_search(inputs), leavers > 0);
    }
}

#[test]
fn a_fixed_foresight_is_kept_and_others_go_by_speed() {
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
    assert_eq!(cost.searching, u64::MAX);
    assert!(!is_full_search(PlanInputs { cost, ..left(1) }));
}
