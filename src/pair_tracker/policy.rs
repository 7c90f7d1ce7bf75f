//! What an update does: a function from what is known to a plan.
//!
//! Comparing boxes that are known to be near each other is cheap. Looking a few boxes up among all others costs more. A
//! full run, a search for all pairs, costs most, but it postpones the next ones. The costs are in `tuning`.

use super::foresight::{Foresight, Motion, Spent};
use crate::Work;
use crate::tuning::prices::{COMPARED, FOUND, LOOKED_UP, PICKED, SEARCHED, WALKED};
use crate::tuning::update::{COMPARE_ALL_FROM_ONE_IN, FULL_RUN_SLACK, LISTS_COST, MOST_CANDIDATES};

/// What decides the plan of an update.
#[derive(Clone, Copy, Debug)]
pub(super) struct Known {
    /// Slots there is room for.
    pub(super) slots: usize,
    /// Proxies that were placed, refused or removed.
    pub(super) moved: usize,
    /// Those of them that have left their fat boxes, have none yet, or are gone.
    pub(super) escaped: usize,
    /// Candidates, and those of them that are held.
    pub(super) candidates: usize,
    pub(super) held: usize,
    /// Rows of the candidates, tombstones included.
    pub(super) rows: usize,
    pub(super) lists: Lists,
    /// Whether escaped proxies may be looked up.
    pub(super) are_layers_used: bool,
    /// The base layer, if it is sorted.
    pub(super) base: Option<Base>,
    /// How far ahead the present fat boxes are drawn.
    pub(super) foresight: Foresight,
    /// What the updates since the last full run have cost, that one among them.
    pub(super) spent: Spent,
}

/// The layers above the base, which the last full run has sorted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Base {
    /// What they have cost since then, in boxes of a run.
    pub(super) spent: usize,
    /// How many slots are recent.
    pub(super) recent: usize,
}

/// Whether there are lists of the candidates of each slot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(super) struct Lists {
    pub(super) are_made: bool,
    /// How often they would have been useful while there were none.
    pub(super) missed: u32,
}

impl Lists {
    /// The most rows that 32-bit links can tell apart.
    pub(super) const MOST_ROWS: usize = 1 << 30;

    /// Whether there can be such a state, with this many rows.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn are_sound(self, rows: usize) -> bool {
        self.missed <= LISTS_COST && (!self.are_made || rows <= Self::MOST_ROWS)
    }
}

/// What an update does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Plan {
    /// Nothing was touched.
    Nothing,
    /// Nothing has left its fat box: candidates are compared.
    Compare(Extent),
    /// Little has: it is looked up in the layers, then candidates are compared.
    LookUp(Extent),
    /// Much has, or is about to: all fat boxes are drawn anew by this foresight, and all pairs searched for.
    FullRun(Foresight),
}

/// Which candidates are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Extent {
    /// All, in order.
    All,
    /// Those of what has moved, picked from all. `lists_are_missed` if lists would have been useful.
    Picked { lists_are_missed: bool },
    /// Those of what has moved, by lists, which are made if there are none.
    Listed,
}

impl Plan {
    /// The plan for an update. `mean_speed`, of what has moved, in box sizes per move, is called only before a full run.
    pub(super) fn of<const D: usize>(
        known: &Known,
        mean_speed: impl FnOnce() -> Option<f64>,
    ) -> Self {
        if known.moved == 0 {
            return Self::Nothing;
        }
        if known.is_full_run_due() {
            let motion = || Motion {
                speed: mean_speed(),
                pairs: known.held as f64 / known.slots as f64,
            };
            return Self::FullRun(known.foresight.adapted::<D>(known.spent, motion));
        }
        let extent = known.extent();
        match known.escaped {
            0 => Self::Compare(extent),
            _ => Self::LookUp(extent),
        }
    }
}

impl Known {
    fn is_full_run_due(&self) -> bool {
        let Some(base) = self.base.filter(|_| self.are_layers_used) else {
            return self.escaped > 0;
        };
        if self.escaped == 0 {
            return false;
        }
        let [escaped, slots, found] = [self.escaped, self.slots, self.candidates].map(to_u64);
        let full_run = SEARCHED * slots + FOUND * found;
        let look_ups = LOOKED_UP * escaped + SEARCHED * (to_u64(base.recent) + escaped);
        // As long as an update costs less than the mean of those since the last full run, that run still pays. Fat boxes that
        // were drawn at one time tend to be left at one time; then it no longer does.
        let mean = self.spent.searching / self.spent.updates.max(1);
        look_ups > mean.saturating_add(full_run / FULL_RUN_SLACK) || base.spent > self.slots
    }

    fn extent(&self) -> Extent {
        if self.moved >= self.slots / COMPARE_ALL_FROM_ONE_IN {
            return Extent::All;
        }
        let is_cheaper = WALKED * to_u64(self.moved) < PICKED * to_u64(self.rows);
        let are_few = is_cheaper && self.rows <= Lists::MOST_ROWS;
        match self.lists {
            _ if !are_few => Extent::Picked {
                lists_are_missed: false,
            },
            Lists { are_made, missed } if are_made || missed >= LISTS_COST => Extent::Listed,
            _ => Extent::Picked {
                lists_are_missed: true,
            },
        }
    }
}

/// What an update has cost that has renewed this number of boxes.
pub(super) fn price(work: &Work, moved: usize) -> Spent {
    let priced = |units: &[(usize, u64)]| {
        let all = units
            .iter()
            .map(|&(count, price)| price.saturating_mul(to_u64(count)));
        all.fold(0, u64::saturating_add)
    };
    let searching = priced(&[
        (work.looked_up, LOOKED_UP),
        (work.searched, SEARCHED),
        (work.found, FOUND),
    ]);
    let comparing = priced(&[
        (work.compared, COMPARED),
        (work.picked, PICKED),
        (work.walked, WALKED),
    ]);
    Spent {
        updates: 1,
        moved: to_u64(moved),
        searching,
        all: searching.saturating_add(comparing),
    }
}

fn to_u64(count: usize) -> u64 {
    count as u64
}

/// Whether there are more candidates than foresight can be worth.
pub(super) fn are_too_many(candidates: usize, slots: usize, held: usize) -> bool {
    candidates / MOST_CANDIDATES > slots + held
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A world of 1000 proxies at rest, with lists out of date, and one full run that has cost as much as one does.
    fn world() -> Known {
        Known {
            slots: 1000,
            moved: 0,
            escaped: 0,
            candidates: 4000,
            held: 2000,
            rows: 5000,
            lists: Lists::default(),
            are_layers_used: true,
            base: Some(Base::default()),
            foresight: Foresight::new(None),
            spent: Spent {
                updates: 1,
                moved: 1000,
                searching: FULL_RUN,
                all: FULL_RUN,
            },
        }
    }

    /// What a full run costs in this world.
    const FULL_RUN: u64 = 1000 * SEARCHED + 4000 * FOUND;

    /// What it costs more to look one up than not to, with none in the upper layers.
    const LOOK_UP: u64 = LOOKED_UP + SEARCHED;

    const PICKED_ONLY: Extent = Extent::Picked {
        lists_are_missed: false,
    };
    const MISSED: Extent = Extent::Picked {
        lists_are_missed: true,
    };

    fn plan(known: Known) -> Plan {
        Plan::of::<2>(&known, || Some(0.1))
    }

    fn is_full_run(known: Known) -> bool {
        matches!(plan(known), Plan::FullRun(_))
    }

    #[test]
    fn nothing_is_done_if_nothing_was_touched() {
        assert_eq!(plan(world()), Plan::Nothing);
        let unsorted = Known {
            base: None,
            ..world()
        };
        assert_eq!(plan(unsorted), Plan::Nothing);
    }

    #[test]
    fn candidates_are_compared_to_the_extent_of_what_has_moved() {
        let extent = |moved| match plan(Known { moved, ..world() }) {
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
        let extent = |moved, rows| {
            let known = Known {
                moved,
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
            moved: PICKED as usize,
            rows: WALKED as usize,
            ..world()
        };
        assert_eq!(plan(equal), Plan::Compare(PICKED_ONLY));
    }

    #[test]
    fn lists_are_made_once_they_were_missed_often_enough() {
        let extent = |are_made, missed, rows| {
            let lists = Lists { are_made, missed };
            plan(Known {
                moved: 1,
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
        let most = Lists::MOST_ROWS;
        assert_eq!(extent(true, 8, most), Plan::Compare(Extent::Listed));
        assert_eq!(extent(true, 8, most + 1), Plan::Compare(PICKED_ONLY));
    }

    #[test]
    fn few_escaped_are_looked_up_and_many_are_a_full_run() {
        // The update after a full run: up to what that has cost, and a part of it.
        let most = (FULL_RUN + FULL_RUN / FULL_RUN_SLACK) / LOOK_UP;
        let known = |escaped: u64| Known {
            moved: 500,
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
            moved: 500,
            escaped: 100,
            spent: Spent {
                updates: 3,
                searching,
                ..world().spent
            },
            ..world()
        };
        let equal = 3 * (100 * LOOK_UP - slack);
        assert_eq!(plan(known(equal)), Plan::LookUp(Extent::All));
        assert!(is_full_run(known(equal - 1)));
    }

    #[cfg(feature = "serde-serialize")]
    #[test]
    fn lists_are_sound_within_their_limits() {
        let are_sound = |are_made, missed, rows| Lists { are_made, missed }.are_sound(rows);
        let most = Lists::MOST_ROWS;
        assert!(are_sound(false, LISTS_COST, 0) && !are_sound(false, LISTS_COST + 1, 0));
        assert!(are_sound(true, 0, most) && !are_sound(true, 0, most + 1));
        assert!(are_sound(true, LISTS_COST, 0) && !are_sound(true, LISTS_COST + 1, 0));
        assert!(are_sound(false, 0, most + 1));
    }

    #[test]
    fn the_longer_a_full_run_has_paid_the_fewer_end_it() {
        let known = |updates, recent, escaped: u64| Known {
            moved: 500,
            escaped: escaped as usize,
            base: Some(Base { spent: 0, recent }),
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
            moved: 500,
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
            let most = full_run / FULL_RUN_SLACK / LOOK_UP;
            assert_eq!(plan(known(candidates, most)), Plan::LookUp(Extent::All));
            assert!(is_full_run(known(candidates, most + 1)));
        }
    }

    #[test]
    fn a_full_run_is_due_once_the_layers_have_cost_as_much() {
        let known = |spent, escaped| Known {
            moved: 10,
            escaped,
            base: Some(Base { spent, recent: 0 }),
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
            moved: 500,
            escaped: 1,
            spent: Spent {
                updates: 0,
                moved: u64::MAX,
                searching: u64::MAX,
                all: u64::MAX,
            },
            ..world()
        };
        assert_eq!(plan(known), Plan::LookUp(Extent::All));
    }

    #[test]
    fn without_a_sorted_base_layer_every_search_is_a_full_run() {
        for known in [
            Known {
                base: None,
                ..world()
            },
            Known {
                are_layers_used: false,
                ..world()
            },
        ] {
            let [still, one] = [0, 1].map(|escaped| Known {
                moved: 400,
                escaped,
                ..known
            });
            assert_eq!(plan(still), Plan::Compare(Extent::All));
            assert!(is_full_run(one));
        }
    }

    #[test]
    fn a_fixed_foresight_is_kept_and_others_are_adapted() {
        let known = Known {
            moved: 1000,
            escaped: 1000,
            ..world()
        };
        let fixed = Known {
            foresight: Foresight::new(Some(5)),
            ..known
        };
        let unasked = || panic!("the speed decides nothing");
        let Plan::FullRun(foresight) = Plan::of::<2>(&fixed, unasked) else {
            panic!("all have escaped");
        };
        assert_eq!(foresight.moves(), 5);
        let Plan::FullRun(foresight) = plan(known) else {
            panic!("all have escaped");
        };
        let motion = || Motion {
            speed: Some(0.1),
            pairs: 2.0,
        };
        let expected = known.foresight.adapted::<2>(known.spent, motion);
        assert_eq!(foresight, expected);
        assert_ne!(foresight, known.foresight);
    }

    #[test]
    fn work_is_priced_by_unit() {
        let work = Work {
            compared: 1,
            picked: 10,
            walked: 100,
            looked_up: 1000,
            searched: 10_000,
            found: 100_000,
        };
        let searching = 1000 * LOOKED_UP + 10_000 * SEARCHED + 100_000 * FOUND;
        let expected = Spent {
            updates: 1,
            moved: 7,
            searching,
            all: searching + COMPARED + 10 * PICKED + 100 * WALKED,
        };
        assert_eq!(price(&work, 7), expected);
    }

    #[test]
    fn candidates_are_too_many_from_eight_a_proxy_and_pair_on() {
        assert!(!are_too_many(8 * 30 + 7, 10, 20));
        assert!(are_too_many(8 * 31, 10, 20));
    }
}
