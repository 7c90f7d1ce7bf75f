//! What an update does: a function from what is known to a plan.
//!
//! Comparing boxes that are known to be near each other is cheap. Looking a few boxes up among all others costs more. A
//! full run, a search for all pairs, costs most, but it postpones the next ones. The costs are in `tuning`.

use super::horizon::{Experience, Horizon};
use crate::tuning::update::{
    COMPARE_ALL_FROM_ONE_IN, LISTS_COST, LOOKUP_COST, MOST_CANDIDATES, WALK_COST, WAVE,
};

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
    /// The horizon of the present fat boxes.
    pub(super) horizon: Horizon,
    /// The foresight that the user has fixed, in moves.
    pub(super) fixed_foresight: Option<u16>,
}

/// What has been spent since the base layer was sorted, by the last full run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Base {
    pub(super) updates: u64,
    /// Proxies that escaped in these updates, added up.
    pub(super) escaped: u64,
    /// What the layers above it have cost, in boxes of a run.
    pub(super) spent: usize,
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
    /// Much has, or is about to: all fat boxes are drawn anew by this horizon, and all pairs searched for.
    FullRun(Horizon),
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
            return Self::FullRun(match known.fixed_foresight {
                Some(moves) => Horizon::fixed(moves),
                None => known.horizon.adapted::<D>(mean_speed(), known.experience()),
            });
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
        let [escaped, slots] = [self.escaped as u64, self.slots as u64];
        let [times, part] = WAVE;
        // Fat boxes that were made at the same time tend to be left at the same time; a run makes them all anew.
        let is_wave = escaped * base.updates > times * base.escaped && part * escaped > slots;
        let is_costly = LOOKUP_COST * self.escaped > self.slots || base.spent > self.slots;
        self.escaped > 0 && (is_costly || is_wave)
    }

    fn extent(&self) -> Extent {
        if self.moved >= self.slots / COMPARE_ALL_FROM_ONE_IN {
            return Extent::All;
        }
        let are_few = WALK_COST * self.moved < self.rows && self.rows <= Lists::MOST_ROWS;
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

    /// What the present horizon has cost and yielded, if there is a full run now.
    fn experience(&self) -> Experience {
        let slots = self.slots as f64;
        let full_runs = |base: Base| {
            let look_ups = LOOKUP_COST as f64 * base.escaped as f64 / slots;
            (1.0 + look_ups) / (base.updates + 1) as f64
        };
        Experience {
            pairs: self.held as f64 / slots,
            excess: (self.candidates - self.held) as f64 / slots,
            cost: self.base.map(full_runs),
        }
    }
}

/// Whether there are more candidates than foresight can be worth.
pub(super) fn are_too_many(candidates: usize, slots: usize, held: usize) -> bool {
    candidates / MOST_CANDIDATES > slots + held
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A world of 1000 proxies at rest, with lists out of date.
    const WORLD: Known = Known {
        slots: 1000,
        moved: 0,
        escaped: 0,
        candidates: 4000,
        held: 2000,
        rows: 5000,
        lists: Lists {
            are_made: false,
            missed: 0,
        },
        are_layers_used: true,
        base: Some(Base {
            updates: 0,
            escaped: 0,
            spent: 0,
        }),
        horizon: Horizon::FIRST,
        fixed_foresight: None,
    };

    const PICKED: Extent = Extent::Picked {
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
        assert_eq!(plan(WORLD), Plan::Nothing);
        let unsorted = Known {
            base: None,
            ..WORLD
        };
        assert_eq!(plan(unsorted), Plan::Nothing);
    }

    #[test]
    fn candidates_are_compared_to_the_extent_of_what_has_moved() {
        let extent = |moved| match plan(Known { moved, ..WORLD }) {
            Plan::Compare(extent) => extent,
            other => panic!("{other:?}"),
        };
        assert_eq!(extent(1000), Extent::All);
        assert_eq!(extent(333), Extent::All);
        assert_eq!(extent(332), PICKED);
        // 32 rows a walk: 5000 rows are worth 156 walks.
        assert_eq!(extent(157), PICKED);
        assert_eq!(extent(156), MISSED);
        assert_eq!(extent(1), MISSED);
    }

    #[test]
    fn as_many_walks_as_rows_cost_are_still_picked() {
        let known = Known {
            moved: 100,
            rows: 3200,
            ..WORLD
        };
        assert_eq!(plan(known), Plan::Compare(PICKED));
        let known = Known {
            rows: 3201,
            ..known
        };
        assert_eq!(plan(known), Plan::Compare(MISSED));
    }

    #[test]
    fn lists_are_made_once_they_were_missed_often_enough() {
        let extent = |are_made, missed, rows| {
            let lists = Lists { are_made, missed };
            plan(Known {
                moved: 1,
                lists,
                rows,
                ..WORLD
            })
        };
        assert_eq!(extent(false, 7, 5000), Plan::Compare(MISSED));
        assert_eq!(extent(false, 8, 5000), Plan::Compare(Extent::Listed));
        assert_eq!(extent(true, 0, 5000), Plan::Compare(Extent::Listed));
        // One mover is too many for that few candidates.
        assert_eq!(extent(true, 0, 32), Plan::Compare(PICKED));
        // Links could not tell more apart.
        let most = Lists::MOST_ROWS;
        assert_eq!(extent(true, 8, most), Plan::Compare(Extent::Listed));
        assert_eq!(extent(true, 8, most + 1), Plan::Compare(PICKED));
    }

    #[test]
    fn few_escaped_are_looked_up_and_many_are_a_full_run() {
        let base = Some(Base {
            updates: 1,
            escaped: 1000,
            spent: 0,
        });
        let known = |escaped| Known {
            moved: 500,
            escaped,
            base,
            ..WORLD
        };
        assert_eq!(plan(known(1)), Plan::LookUp(Extent::All));
        assert_eq!(plan(known(166)), Plan::LookUp(Extent::All));
        assert!(is_full_run(known(167)));
    }

    #[test]
    fn a_full_run_is_due_once_the_layers_have_cost_as_much() {
        let known = |spent, escaped| {
            let base = Some(Base {
                updates: 9,
                escaped: 90,
                spent,
            });
            Known {
                moved: 10,
                escaped,
                base,
                ..WORLD
            }
        };
        assert_eq!(plan(known(1000, 1)), Plan::LookUp(MISSED));
        assert!(is_full_run(known(1001, 1)));
        // It can wait until something has escaped.
        assert_eq!(plan(known(1001, 0)), Plan::Compare(MISSED));
    }

    #[test]
    fn a_wave_is_a_full_run() {
        let known = |escaped, updates| {
            let base = Some(Base {
                updates,
                escaped: 50,
                spent: 0,
            });
            Known {
                moved: 400,
                escaped,
                base,
                ..WORLD
            }
        };
        // Five in each of ten updates, and now more than eight times as many, and more than one in 24.
        assert_eq!(plan(known(41, 10)), Plan::LookUp(Extent::All));
        assert!(is_full_run(known(42, 10)));
        assert_eq!(plan(known(50, 8)), Plan::LookUp(Extent::All));
        assert!(is_full_run(known(51, 8)));
        let first = Known {
            base: Some(Base::default()),
            ..known(42, 0)
        };
        assert_eq!(plan(first), Plan::LookUp(Extent::All));
    }

    #[test]
    fn without_a_sorted_base_layer_every_search_is_a_full_run() {
        for known in [
            Known {
                base: None,
                ..WORLD
            },
            Known {
                are_layers_used: false,
                ..WORLD
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
            ..WORLD
        };
        let fixed = Known {
            fixed_foresight: Some(5),
            ..known
        };
        let unasked = || panic!("the speed decides nothing");
        let Plan::FullRun(horizon) = Plan::of::<2>(&fixed, unasked) else {
            panic!("all have escaped");
        };
        assert_eq!(horizon.moves(), 5);
        let Plan::FullRun(horizon) = plan(known) else {
            panic!("all have escaped");
        };
        assert_eq!(
            horizon,
            WORLD.horizon.adapted::<2>(Some(0.1), known.experience())
        );
    }

    #[test]
    fn experience_is_counted_by_slot_and_by_update() {
        let base = Some(Base {
            updates: 3,
            escaped: 500,
            spent: 77,
        });
        let experience = Known { base, ..WORLD }.experience();
        assert_eq!(experience.pairs, 2.0);
        assert_eq!(experience.excess, 2.0);
        // A full run, and 500 look-ups of six boxes each among 1000, over four updates.
        assert_eq!(experience.cost, Some(1.0));
        let fresh = Known {
            base: None,
            ..WORLD
        };
        assert_eq!(fresh.experience().cost, None);
    }

    #[test]
    fn candidates_are_too_many_from_eight_a_proxy_and_pair_on() {
        assert!(!are_too_many(8 * 30 + 7, 10, 20));
        assert!(are_too_many(8 * 31, 10, 20));
    }
}
