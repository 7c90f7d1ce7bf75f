//! The plan at every border between one decision and another.

use super::*;

/// A world of 1000 slots at rest, with lists out of date, and one full run that has cost as much as one does.
fn world() -> Known {
    Known {
        slots: 1000,
        touched: 0,
        stirred: 0,
        escaped: 0,
        candidates: 4000,
        rows: 5000,
        lists: ListState::default(),
        are_layers_used: true,
        above_base: Some(AboveBase::default()),
        foresight: Foresight::new(None),
        spent: Spent {
            updates: 1,
            searching: FULL_RUN,
        },
    }
}

/// What a full run costs in this world.
const FULL_RUN: u64 = 1000 * SEARCHED + 4000 * FOUND;

/// What it costs more to look one up than not to, with none in the upper layers: it finds both ends' share of four
/// candidates a slot.
const LOOK_UP: u64 = LOOKED_UP + SEARCHED + 8 * FOUND;

const PICKED_ONLY: Extent = Extent::Picked {
    lists_are_missed: false,
};
const MISSED: Extent = Extent::Picked {
    lists_are_missed: true,
};

fn plan(known: Known) -> Plan {
    Plan::of(&known, || Some(0.1))
}

fn is_full_run(known: Known) -> bool {
    matches!(plan(known), Plan::FullRun(_))
}

#[test]
fn nothing_is_done_if_nothing_was_touched() {
    assert_eq!(plan(world()), Plan::Nothing);
    let unsorted = Known {
        above_base: None,
        ..world()
    };
    assert_eq!(plan(unsorted), Plan::Nothing);
}

#[test]
fn what_has_another_volume_alone_asks_for_a_comparison_and_changes_no_extent() {
    for touched in [0, 1, 10, 100, 400] {
        let known = |stirred| Known {
            touched,
            stirred,
            ..world()
        };
        assert_eq!(plan(known(500)), Plan::Compare(known(0).extent()));
    }
}

#[test]
fn candidates_are_compared_to_the_extent_of_what_was_touched() {
    let extent = |touched| match plan(Known { touched, ..world() }) {
        Plan::Compare(extent) => extent,
        other => panic!("{other:?}"),
    };
    assert_eq!(extent(1000), Extent::All);
    assert_eq!(extent(333), Extent::All);
    assert_eq!(extent(332), PICKED_ONLY);
    assert_eq!(extent(1), MISSED);
}

#[test]
fn as_many_walks_as_picking_costs_are_still_picked() {
    // A walk is worth picking from this many rows.
    let rows = (100 * WALKED).div_ceil(PICKED) as usize;
    let extent = |touched, rows| {
        let known = Known {
            touched,
            rows,
            ..world()
        };
        match plan(known) {
            Plan::Compare(extent) => extent,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(extent(100, rows + 1), MISSED);
    assert_eq!(extent(100, rows - 1), PICKED_ONLY);
    assert_eq!(extent(101, rows), PICKED_ONLY);
    assert_eq!(extent(99, rows), MISSED);
    let equal = Known {
        touched: PICKED as usize,
        rows: WALKED as usize,
        ..world()
    };
    assert_eq!(plan(equal), Plan::Compare(PICKED_ONLY));
}

#[test]
fn lists_are_made_once_they_were_missed_often_enough() {
    let extent = |are_made, missed, rows| {
        let lists = ListState { are_made, missed };
        plan(Known {
            touched: 1,
            lists,
            rows,
            ..world()
        })
    };
    assert_eq!(extent(false, 7, 5000), Plan::Compare(MISSED));
    assert_eq!(extent(false, 8, 5000), Plan::Compare(Extent::Listed));
    assert_eq!(extent(true, 0, 5000), Plan::Compare(Extent::Listed));
    // One mover is too many for that few candidates.
    assert_eq!(extent(true, 0, 10), Plan::Compare(PICKED_ONLY));
    // Links could not tell more apart.
    let most = ListState::MOST_ROWS;
    assert_eq!(extent(true, 8, most), Plan::Compare(Extent::Listed));
    assert_eq!(extent(true, 8, most + 1), Plan::Compare(PICKED_ONLY));
}

#[test]
fn few_escaped_are_looked_up_and_many_are_a_full_run() {
    // The update after a full run: up to what that has cost, and a part of it.
    let most = (FULL_RUN + FULL_RUN / FULL_RUN_SLACK) / LOOK_UP;
    let known = |escaped: u64| Known {
        touched: 500,
        escaped: escaped as usize,
        ..world()
    };
    assert_eq!(plan(known(1)), Plan::LookUp(Extent::All));
    assert_eq!(plan(known(most)), Plan::LookUp(Extent::All));
    assert!(is_full_run(known(most + 1)));
}

#[test]
fn look_ups_may_cost_as_much_as_the_mean() {
    let slack = FULL_RUN / FULL_RUN_SLACK;
    let known = |searching| Known {
        touched: 500,
        escaped: 100,
        spent: Spent {
            updates: 3,
            searching,
        },
        ..world()
    };
    let equal = 3 * (100 * LOOK_UP - slack);
    assert_eq!(plan(known(equal)), Plan::LookUp(Extent::All));
    assert!(is_full_run(known(equal - 1)));
}

#[test]
fn the_longer_a_full_run_has_paid_the_fewer_end_it() {
    let known = |updates, recent, escaped: u64| Known {
        touched: 500,
        escaped: escaped as usize,
        above_base: Some(AboveBase { spent: 0, recent }),
        spent: Spent {
            updates,
            ..world().spent
        },
        ..world()
    };
    let slack = FULL_RUN / FULL_RUN_SLACK;
    for updates in [2, 10, 1000] {
        let most = (FULL_RUN / updates + slack) / LOOK_UP;
        assert_eq!(plan(known(updates, 0, most)), Plan::LookUp(Extent::All));
        assert!(is_full_run(known(updates, 0, most + 1)));
        // What is recent is searched as well.
        let most = (FULL_RUN / updates + slack - 8 * SEARCHED) / LOOK_UP;
        assert_eq!(plan(known(updates, 8, most)), Plan::LookUp(Extent::All));
        assert!(is_full_run(known(updates, 8, most + 1)));
    }
}

#[test]
fn a_full_run_that_finds_more_may_be_put_off_for_more() {
    let known = |candidates, escaped: u64| Known {
        touched: 500,
        escaped: escaped as usize,
        candidates,
        spent: Spent {
            searching: 0,
            ..world().spent
        },
        ..world()
    };
    for candidates in [0, 2000, 100_000] {
        let full_run = 1000 * SEARCHED + candidates as u64 * FOUND;
        let look_up = LOOKED_UP + SEARCHED + candidates as u64 / 500 * FOUND;
        let most = full_run / FULL_RUN_SLACK / look_up;
        assert_eq!(plan(known(candidates, most)), Plan::LookUp(Extent::All));
        assert!(is_full_run(known(candidates, most + 1)));
    }
}

#[test]
fn look_ups_of_all_find_no_more_than_there_is() {
    let known = |escaped: u64, searching| Known {
        touched: 1000,
        escaped: escaped as usize,
        candidates: 100_000,
        spent: Spent {
            searching,
            ..world().spent
        },
        ..world()
    };
    let slack = (1000 * SEARCHED + 100_000 * FOUND) / FULL_RUN_SLACK;
    // From half of all on, each candidate is found; dense worlds are searched in full long before.
    for escaped in [500, 501, 1000] {
        let equal = escaped * (LOOKED_UP + SEARCHED) + 100_000 * FOUND - slack;
        assert_eq!(plan(known(escaped, equal)), Plan::LookUp(Extent::All));
        assert!(is_full_run(known(escaped, equal - 1)));
    }
}

#[test]
fn a_full_run_is_due_once_the_layers_have_cost_as_much() {
    let known = |spent, escaped| Known {
        touched: 10,
        escaped,
        above_base: Some(AboveBase { spent, recent: 0 }),
        ..world()
    };
    let looked_up = |known| matches!(plan(known), Plan::LookUp(_));
    assert!(looked_up(known(1000, 1)));
    assert!(is_full_run(known(1001, 1)));
    // It can wait until something has escaped.
    assert!(matches!(plan(known(1001, 0)), Plan::Compare(_)));
}

#[test]
fn numbers_beyond_all_measure_are_no_panic() {
    let known = Known {
        touched: 500,
        escaped: 1,
        spent: Spent {
            updates: 0,
            searching: u64::MAX,
        },
        ..world()
    };
    assert_eq!(plan(known), Plan::LookUp(Extent::All));
}

#[test]
fn without_a_sorted_base_layer_every_search_is_a_full_run() {
    for known in [
        Known {
            above_base: None,
            ..world()
        },
        Known {
            are_layers_used: false,
            ..world()
        },
    ] {
        let [still, one] = [0, 1].map(|escaped| Known {
            touched: 400,
            escaped,
            ..known
        });
        assert_eq!(plan(still), Plan::Compare(Extent::All));
        assert!(is_full_run(one));
    }
}

#[test]
fn a_fixed_foresight_is_kept_and_others_go_by_speed() {
    let known = Known {
        touched: 1000,
        escaped: 1000,
        ..world()
    };
    let fixed = Known {
        foresight: Foresight::new(Some(5)),
        ..known
    };
    let unasked = || panic!("the speed decides nothing");
    let Plan::FullRun(foresight) = Plan::of(&fixed, unasked) else {
        panic!("all have escaped");
    };
    assert_eq!(foresight.moves(), 5);
    let Plan::FullRun(foresight) = plan(known) else {
        panic!("all have escaped");
    };
    assert_eq!(foresight, known.foresight.renewed(|| Some(0.1)));
    assert_ne!(foresight, known.foresight);
}

#[test]
fn searching_is_priced_by_unit() {
    let work = Work {
        compared: 1,
        picked: 10,
        walked: 100,
        looked_up: 1000,
        searched: 10_000,
        found: 100_000,
    };
    let mut spent = Spent::default();
    spent.add(&work);
    spent.add(&Work::default());
    let searching = 1000 * LOOKED_UP + 10_000 * SEARCHED + 100_000 * FOUND;
    assert_eq!(
        spent,
        Spent {
            updates: 2,
            searching
        }
    );
    spent.add(&Work {
        found: usize::MAX,
        ..work
    });
    assert_eq!(spent.searching, u64::MAX);
}

#[test]
fn candidates_are_too_many_from_eight_a_slot_and_pair_on() {
    assert!(!are_too_many(8 * 30 + 7, 10, 20));
    assert!(are_too_many(8 * 31, 10, 20));
}
