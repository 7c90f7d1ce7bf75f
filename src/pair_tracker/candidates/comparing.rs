//! Brings candidates up to date with the proxies, and reports which pairs begin and end.

use super::array::{CandidateArray, TOMBSTONE, gather};
use super::state::PairState;
use crate::bit_set::BitSet;
use crate::pair_tracker::proxies::Proxies;
use crate::pair_tracker::{FilterKey, PairChange};
use crate::real::Real;

/// The candidates of an update, what decides which of them are held, and whom changes are reported to.
pub(super) struct Comparing<'a, R, const D: usize, K, F> {
    pub(super) array: &'a mut CandidateArray,
    pub(super) proxies: &'a Proxies<R, D, K>,
    pub(super) report: &'a mut F,
}

impl<R: Real, const D: usize, K: FilterKey, F: FnMut(PairChange)> Comparing<'_, R, D, K, F> {
    /// Makes `found` the candidates, and leaves the memory of the former ones there.
    pub(super) fn replace(&mut self, found: &mut Vec<[u32; 2]>) {
        let Self {
            array,
            proxies,
            report,
        } = self;
        let CandidateArray {
            pairs,
            states,
            retired,
            answers,
            held_count,
            ..
        } = &mut **array;
        if proxies.has_volumes() {
            retired.reserve(*held_count);
            let rows = pairs.iter().zip(states.iter());
            let held = rows.filter(|(_, state)| state.is_held());
            for (&pair, _) in held.filter(|&(&pair, _)| proxies.are_left(pair)) {
                retired.insert(pair);
            }
        } else {
            answers.ask(pairs.len(), |rows| {
                let rows = pairs[rows.clone()].iter().zip(&states[rows]);
                gather(rows, |(&pair, state)| {
                    state.is_held() && proxies.has_ended(pair)
                })
            });
            let ended = answers.iter();
            ended.for_each(|row| report(PairChange::Deleted(pairs[row])));
        }
        std::mem::swap(pairs, found);
        states.clear();
        let pairs = std::mem::take(pairs);
        array.held_count = 0;
        array.overlapping_count = 0;
        array.tombstones = 0;
        self.hold_new(&pairs);
        self.array.retired.free_if_large();
        self.array.pairs = pairs;
    }

    /// Adds candidates.
    pub(super) fn extend(&mut self, found: &[[u32; 2]]) {
        self.hold_new(found);
        self.array.pairs.extend_from_slice(found);
    }

    fn hold_new(&mut self, found: &[[u32; 2]]) {
        let Self {
            array,
            proxies,
            report,
        } = self;
        let CandidateArray {
            states,
            retired,
            held_count,
            overlapping_count,
            answers,
            ..
        } = &mut **array;
        answers.ask(found.len(), |rows| {
            gather(&found[rows], |&pair| proxies.overlap(pair))
        });
        let first = states.len();
        states.resize(first + found.len(), PairState::Apart);
        for i in answers.iter() {
            let pair = found[i];
            // Most pairs that are held were held before.
            let was_held = match proxies.has_volumes() {
                true => retired.take(pair),
                false => proxies.was_held(pair),
            };
            let state = proxies.state_of_overlapping(pair, was_held);
            states[first + i] = state;
            *held_count += usize::from(state.is_held());
            *overlapping_count += 1;
            match (was_held, state.is_held()) {
                (false, true) => report(PairChange::Added(pair)),
                (true, false) => report(PairChange::Deleted(pair)),
                _ => {}
            }
        }
        retired.drain(|pair| report(PairChange::Deleted(pair)));
    }

    /// Compares all rows, and removes those of what has left its fat box. No row may be a tombstone. Returns whether rows have
    /// moved.
    pub(super) fn compare_all(&mut self, toggled: &mut BitSet) -> bool {
        debug_assert_eq!(self.array.tombstones, 0);
        let CandidateArray { pairs, states, .. } = &*self.array;
        let (proxies, leavers) = (self.proxies, &self.proxies.leavers);
        // Which ones overlap is practically random, so there is no branch on it, only on whether any of many has toggled.
        if leavers.len() == 0 {
            toggled.ask(pairs.len(), |rows| {
                proxies.toggled(&pairs[rows.clone()], &states[rows])
            });
            for row in toggled.iter() {
                self.compare(row);
            }
            return false;
        }
        let has_left = |&[a, b]: &[u32; 2]| leavers.contains(a) | leavers.contains(b);
        toggled.ask(pairs.len(), |rows| {
            let (pairs, states) = (&pairs[rows.clone()], &states[rows]);
            proxies.toggled(pairs, states) | gather(pairs, has_left)
        });
        let rows = pairs.len();
        for row in toggled.iter() {
            self.compare_or_retire(row);
        }
        // Backwards, so that the row `swap_remove` moves in has already been checked.
        for row in toggled.iter_backwards() {
            if self.array.pairs[row][0] == TOMBSTONE {
                self.array.pairs.swap_remove(row);
                self.array.states.swap_remove(row);
            }
        }
        self.array.tombstones = 0;
        self.array.pairs.len() < rows
    }

    /// Compares the rows that are near, and that have one of these slots, by their volumes alone.
    pub(super) fn compare_near(
        &mut self,
        toggled: &mut BitSet,
        is_one: impl Fn(usize) -> bool + Sync + Send,
    ) {
        let CandidateArray { pairs, states, .. } = &*self.array;
        let proxies = self.proxies;
        let has_one = |[a, b]: [u32; 2]| is_one(a as usize) | is_one(b as usize);
        toggled.ask(pairs.len(), |rows| {
            proxies.toggled_near(&pairs[rows.clone()], &states[rows], has_one)
        });
        for row in toggled.iter() {
            self.set_state(row, PairState::Held);
        }
    }

    /// Compares a row, or retires it if one of its proxies has left its fat box.
    #[inline(always)]
    pub(super) fn compare_or_retire(&mut self, row: usize) {
        let pair = self.array.get(row);
        let leavers = &self.proxies.leavers;
        if pair.is_some_and(|pair| pair.iter().any(|&slot| leavers.contains(slot))) {
            self.retire(row);
        } else {
            self.compare(row);
        }
    }

    /// Brings a row up to date. Returns whether there is a candidate in it.
    #[inline(always)]
    pub(super) fn compare(&mut self, row: usize) -> bool {
        let Some(pair) = self.array.get(row) else {
            return false;
        };
        let former = self.array.states[row];
        let state = self.proxies.state_of(pair, former);
        if state != former {
            self.set_state(row, state);
        }
        true
    }

    #[inline(always)]
    fn set_state(&mut self, row: usize, state: PairState) {
        let array = &mut *self.array;
        let former = std::mem::replace(&mut array.states[row], state);
        array.overlapping_count += usize::from(state.overlaps());
        array.overlapping_count -= usize::from(former.overlaps());
        match (former.is_held(), state.is_held()) {
            (false, true) => {
                (self.report)(PairChange::Added(array.pairs[row]));
                array.held_count += 1;
            }
            (true, false) => {
                (self.report)(PairChange::Deleted(array.pairs[row]));
                array.held_count -= 1;
            }
            _ => {}
        }
    }

    /// Puts a tombstone in place of a candidate when one of its proxies has left its fat box or is gone.
    #[inline(always)]
    pub(super) fn retire(&mut self, row: usize) {
        let (array, proxies) = (&mut *self.array, self.proxies);
        let Some(pair) = array.get(row) else {
            return;
        };
        array.pairs[row] = [TOMBSTONE; 2];
        array.tombstones += 1;
        let state = std::mem::take(&mut array.states[row]);
        array.overlapping_count -= usize::from(state.overlaps());
        if state.is_held() {
            array.held_count -= 1;
            if proxies.has_volumes() {
                if proxies.are_left(pair) {
                    array.retired.insert(pair);
                }
            } else if proxies.has_ended(pair) {
                (self.report)(PairChange::Deleted(pair));
            }
        }
    }
}
