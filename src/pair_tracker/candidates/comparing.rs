//! Brings candidates up to date with the proxies, and reports which pairs begin and end.

use core::ops::Range;

use super::state::PairState;
use super::{Candidates, TOMBSTONE, gather};
use crate::pair_tracker::policy::CompareMode;
use crate::pair_tracker::proxies::Proxies;
use crate::pair_tracker::{FilterKey, PairChange, PairObserver};
use crate::real::Real;
use crate::stats::Work;

/// The candidates of an update, what decides which of them are held, and whom changes are reported to.
pub(in crate::pair_tracker) struct Comparing<'a, R, const D: usize, K, O> {
    pub(in crate::pair_tracker) candidates: &'a mut Candidates,
    pub(in crate::pair_tracker) proxies: &'a Proxies<R, D, K>,
    pub(in crate::pair_tracker) observer: &'a mut O,
}

impl<R: Real, const D: usize, K: FilterKey, O: PairObserver> Comparing<'_, R, D, K, O> {
    /// Makes `found` the candidates, and leaves the memory of the former ones there.
    pub(in crate::pair_tracker) fn replace(&mut self, found: &mut Vec<[u32; 2]>) {
        let Self {
            candidates,
            proxies,
            observer,
        } = self;
        let Candidates {
            pairs,
            states,
            retired,
            forbidden,
            answers,
            held_count,
            ..
        } = &mut **candidates;
        if proxies.have_history() {
            retired.reserve(*held_count);
            for (&pair, &state) in pairs.iter().zip(states.iter()) {
                if state.is_held() && proxies.are_left(pair) {
                    retired.insert(pair);
                } else if state == PairState::Near && proxies.is_forbidden(pair) {
                    forbidden.push(pair);
                }
            }
        } else {
            answers.ask(pairs.len(), |rows| {
                let rows = pairs[rows.clone()].iter().zip(&states[rows]);
                gather(rows, |(&pair, state)| {
                    state.is_held() && proxies.has_ended(pair)
                })
            });
            let ended = answers.iter();
            ended.for_each(|row| observer.report(PairChange::Deleted(pairs[row])));
        }
        states.clear();
        candidates.held_count = 0;
        candidates.overlapping_count = 0;
        candidates.tombstones = 0;
        candidates.lists.forget();
        self.keep_forbidden(found);
        self.hold_new(found);
        self.candidates.retired.free_if_large();
        std::mem::swap(&mut self.candidates.pairs, found);
    }

    /// Adds candidates.
    pub(in crate::pair_tracker) fn extend(&mut self, found: &mut Vec<[u32; 2]>) {
        self.keep_forbidden(found);
        self.hold_new(found);
        let Candidates { pairs, lists, .. } = &mut *self.candidates;
        let first = pairs.len();
        pairs.extend_from_slice(found);
        lists.extend(pairs, first, self.proxies.len());
    }

    /// Appends to what was found the pairs whose boxes overlapped and still do, and that were not found because their keys have come to
    /// forbid them.
    fn keep_forbidden(&mut self, found: &mut Vec<[u32; 2]>) {
        let (candidates, proxies) = (&mut *self.candidates, self.proxies);
        if proxies.are_rekeyed {
            let held = candidates.retired.iter();
            let held = held.filter(|&pair| proxies.is_forbidden(pair));
            let all = held.chain(candidates.forbidden.drain(..));
            found.extend(all.filter(|&pair| proxies.overlap(pair)));
        }
    }

    /// Appends the states of candidates that were found.
    fn hold_new(&mut self, found: &[[u32; 2]]) {
        let proxies = self.proxies;
        let mut overlapping = std::mem::take(&mut self.candidates.answers);
        overlapping.ask(found.len(), |rows| {
            gather(&found[rows], |&pair| proxies.overlap(pair))
        });
        let states = &mut self.candidates.states;
        let first = states.len();
        states.resize(first + found.len(), PairState::Apart);
        self.candidates.retired.index();
        for i in overlapping.iter() {
            let pair = found[i];
            // Most pairs that are held were held before.
            let was_held = match proxies.have_history() {
                true => self.candidates.retired.take(pair),
                false => proxies.was_held(pair),
            };
            let state = proxies.state_of_overlapping(pair, was_held);
            let state = self.settled(pair, was_held, state);
            self.candidates.states[first + i] = state;
            self.candidates.held_count += usize::from(state.is_held());
            self.candidates.overlapping_count += 1;
            self.candidates.note_overlap(pair);
            self.report_change(pair, was_held, state.is_held());
        }
        self.candidates.answers = overlapping;
        let retired = &mut self.candidates.retired;
        retired.drain(|pair| self.observer.report(PairChange::Deleted(pair)));
    }

    /// Brings the candidates of what was touched up to date with the present boxes, and retires those of the leavers. Looks at all
    /// candidates, or only at these. Adds what it took to `work`.
    ///
    /// Picking a few candidates out of all is cheap, and walking lists is not: it waits for memory at each step. So lists are
    /// for very few.
    pub(in crate::pair_tracker) fn compare(&mut self, mode: CompareMode, work: &mut Work) {
        let touched = self.proxies.touched();
        match mode {
            CompareMode::All => {
                self.candidates.compact();
                self.compare_all();
                work.compared = self.candidates.rows();
            }
            CompareMode::Picked { lists_are_missed } => {
                work.picked = self.candidates.rows();
                work.compared = self.compare_picked(touched);
                if lists_are_missed {
                    self.candidates.lists.state.missed += 1;
                }
            }
            CompareMode::Listed => {
                work.walked = touched.len();
                if !self.candidates.lists.state.are_made {
                    self.candidates.make_lists(self.proxies.len());
                }
                let mut lists = std::mem::take(&mut self.candidates.lists);
                for &slot in self.proxies.leavers.slots() {
                    lists.take(slot, |row| self.retire(row));
                }
                for &slot in touched {
                    lists.walk(slot, |row| self.compare_row(row));
                }
                self.candidates.lists = lists;
            }
        }
    }

    /// Brings the candidates of what has another volume in the same box up to date.
    pub(in crate::pair_tracker) fn compare_volumes(&mut self) {
        let proxies = self.proxies;
        let revolumed = &proxies.notes.revolumed;
        if self.candidates.walks_lists(revolumed.len(), proxies.len()) {
            let mut lists = std::mem::take(&mut self.candidates.lists);
            for &slot in revolumed {
                lists.walk(slot, |row| self.compare_row(row));
            }
            self.candidates.lists = lists;
            return;
        }
        self.candidates.passed_over += self.candidates.rows();
        let mut met = std::mem::take(&mut self.candidates.answers);
        let Candidates {
            pairs,
            states,
            slots,
            ..
        } = &mut *self.candidates;
        slots.insert_all(revolumed, proxies.len());
        let is_one = slots.lookup();
        let has_one = |[a, b]: [u32; 2]| is_one(a as usize) | is_one(b as usize);
        met.ask(pairs.len(), |rows| {
            proxies.met_of_near(&pairs[rows.clone()], &states[rows], has_one)
        });
        drop(is_one);
        slots.clear_around(revolumed);
        for row in met.iter() {
            self.compare_row(row);
        }
        self.candidates.answers = met;
    }

    /// Compares all rows, and removes those of what has left its fat box. No row may be a tombstone.
    fn compare_all(&mut self) {
        debug_assert_eq!(self.candidates.tombstones, 0);
        let mut toggled = std::mem::take(&mut self.candidates.answers);
        let Candidates { pairs, states, .. } = &*self.candidates;
        let (proxies, leavers) = (self.proxies, &self.proxies.leavers);
        let has_left = |&[a, b]: &[u32; 2]| leavers.contains(a) | leavers.contains(b);
        // Which ones overlap is practically random, so there is no branch on it, only on whether any of many has toggled.
        let ask_toggled = |rows: Range<usize>| proxies.toggled(&pairs[rows.clone()], &states[rows]);
        match leavers.len() {
            0 => toggled.ask(pairs.len(), ask_toggled),
            _ => toggled.ask(pairs.len(), |rows| {
                ask_toggled(rows.clone()) | gather(&pairs[rows], has_left)
            }),
        }
        for row in toggled.iter() {
            self.compare_or_retire(row);
        }
        let candidates = &mut *self.candidates;
        if candidates.tombstones > 0 {
            // Backwards, so that the row `swap_remove` moves in has already been checked.
            for row in toggled.iter_backwards() {
                if candidates.pairs[row][0] == TOMBSTONE {
                    candidates.pairs.swap_remove(row);
                    candidates.states.swap_remove(row);
                }
            }
            candidates.tombstones = 0;
            // Rows have moved.
            candidates.lists.forget();
        }
        candidates.answers = toggled;
    }

    /// Compares the rows that have one of these slots, or retires them. Returns how many there are, with some tombstones.
    fn compare_picked(&mut self, touched: &[u32]) -> usize {
        let mut picked = std::mem::take(&mut self.candidates.answers);
        let Candidates { pairs, slots, .. } = &mut *self.candidates;
        slots.insert_all(touched, self.proxies.len());
        let is_touched = slots.lookup();
        picked.ask(pairs.len(), |rows| {
            gather(&pairs[rows], |&[a, b]| {
                is_touched(a as usize) | is_touched(b as usize)
            })
        });
        drop(is_touched);
        slots.clear_around(touched);
        let mut count = 0;
        for row in picked.iter() {
            count += 1;
            self.compare_or_retire(row);
        }
        self.candidates.answers = picked;
        count
    }

    /// Compares a row, or retires it if one of its proxies has left its fat box.
    #[inline(always)]
    fn compare_or_retire(&mut self, row: usize) {
        let pair = self.candidates.get(row);
        let leavers = &self.proxies.leavers;
        if pair.is_some_and(|pair| pair.iter().any(|&slot| leavers.contains(slot))) {
            self.retire(row);
        } else {
            self.compare_row(row);
        }
    }

    /// Brings a row up to date. Returns whether there is a candidate in it.
    #[inline(always)]
    fn compare_row(&mut self, row: usize) -> bool {
        let Some(pair) = self.candidates.get(row) else {
            return false;
        };
        let former = self.candidates.states[row];
        let state = self.proxies.state_of(pair, former);
        let state = self.settled(pair, former.is_held(), state);
        if state != former {
            self.set_state(row, state);
        }
        true
    }

    #[inline(always)]
    fn set_state(&mut self, row: usize, state: PairState) {
        let former = self.candidates.set_state(row, state);
        let pair = self.candidates.pairs[row];
        self.report_change(pair, former.is_held(), state.is_held());
    }

    /// The state of a pair that is about to have this one: a pair that ends by its volumes alone is held on to while its contact is
    /// active.
    #[inline(always)]
    fn settled(&self, pair: [u32; 2], was_held: bool, state: PairState) -> PairState {
        match state {
            PairState::Near if was_held && self.observer.is_active(pair) => PairState::Held,
            _ => state,
        }
    }

    #[inline(always)]
    fn report_change(&mut self, pair: [u32; 2], was_held: bool, is_held: bool) {
        match (was_held, is_held) {
            (false, true) => self.observer.report(PairChange::Added(pair)),
            (true, false) => self.observer.report(PairChange::Deleted(pair)),
            _ => {}
        }
    }

    /// Puts a tombstone in place of a candidate when one of its proxies has left its fat box or is gone.
    #[inline(always)]
    fn retire(&mut self, row: usize) {
        let (candidates, proxies) = (&mut *self.candidates, self.proxies);
        let Some(pair) = candidates.get(row) else {
            return;
        };
        let former = candidates.set_state(row, PairState::Apart);
        candidates.pairs[row] = [TOMBSTONE; 2];
        candidates.tombstones += 1;
        match former {
            PairState::Apart => {}
            PairState::Near if proxies.is_forbidden(pair) => candidates.forbidden.push(pair),
            PairState::Near => {}
            PairState::Held if proxies.have_history() => {
                if proxies.are_left(pair) {
                    candidates.retired.insert(pair);
                }
            }
            PairState::Held if proxies.has_ended(pair) => {
                self.observer.report(PairChange::Deleted(pair));
            }
            PairState::Held => {}
        }
    }
}
