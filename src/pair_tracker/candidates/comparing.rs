//! Brings candidates up to date with the proxies, and reports which pairs begin and end.

use super::state::{PairState, near_and_held};
use super::turns::{Found, FoundNotes, Rows, Turn, Turns, next_state};
use super::{Candidates, TOMBSTONE};
use crate::bit_set::{Lookup, gather, ones};
use crate::pair_tracker::odometer::Due;
use crate::pair_tracker::policy::CompareMode;
use crate::pair_tracker::proxies::Proxies;
use crate::pair_tracker::{FilterKey, PairChange, PairObserver};
use crate::parallel::{Section, start_of_part};
use crate::real::Real;
use crate::stats::Work;
use crate::tuning::prices::{COMPARED, HELD, PICKED};

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
            ..
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
        retired.reserve(*held_count);
        answers.ask(pairs.len(), COMPARED, |rows| {
            let [_, held] = near_and_held(&states[rows.clone()]);
            let is_left = |i: usize| proxies.are_left(pairs[rows.start + i]);
            ones(held).fold(0, |word, i| word | u64::from(is_left(i)) << i)
        });
        answers.iter().for_each(|row| retired.insert(pairs[row]));
        if proxies.are_rekeyed {
            let near = pairs.iter().zip(states.iter());
            let near = near.filter(|&(_, &state)| state == PairState::Near);
            let pairs = near.map(|(&pair, _)| pair);
            forbidden.extend(pairs.filter(|&pair| proxies.is_forbidden(pair)));
        }
        states.clear();
        candidates.dues.clear();
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
        let Candidates {
            pairs, dues, lists, ..
        } = &mut *self.candidates;
        let first = pairs.len();
        pairs.extend_from_slice(found);
        if !dues.is_empty() {
            dues.resize(pairs.len(), Due::default());
        }
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
        let mut states = std::mem::take(&mut self.candidates.states);
        let first = states.len();
        states.resize(first + found.len(), PairState::Apart);
        self.candidates.retired.index();
        let section = Section::of(found.len(), self.proxies.volumes.price(HELD));
        let pairs_a_part = found.len().div_ceil(section.parts()).max(1);
        let pairs = found.chunks(pairs_a_part);
        let states_of_parts = states[first..].chunks_mut(pairs_a_part);
        let mut parts: Vec<_> = pairs
            .zip(states_of_parts)
            .map(|(pairs, states)| Found {
                pairs,
                states,
                notes: FoundNotes::default(),
            })
            .collect();
        let (candidates, observer) = (&*self.candidates, &*self.observer);
        section.for_each(&mut parts, |part| {
            part.ask(candidates, self.proxies, observer);
        });
        for Found { notes, .. } in parts {
            self.candidates.held_count += notes.held_count;
            self.candidates.overlapping_count += notes.overlapping_count;
            for place in notes.taken {
                self.candidates.retired.take(place);
            }
            for pair in notes.strangers {
                self.candidates.note_overlap(pair);
            }
            for (pair, is_held) in notes.changed {
                self.report_change(pair, !is_held, is_held);
            }
        }
        self.candidates.states = states;
        let retired = &mut self.candidates.retired;
        retired.drain(|pair| self.observer.report(PairChange::Deleted(pair)));
    }

    /// Brings the candidates of what was touched up to date with the present boxes, and retires those of the leavers. Looks at all
    /// candidates, or only at these. Adds what it took to `work`.
    ///
    /// Picking a few candidates out of all is cheap, and walking lists is not: it waits for memory at each step. So lists are
    /// for very few.
    pub(in crate::pair_tracker) fn compare(&mut self, mode: CompareMode, work: &mut Work) {
        let (proxies, touched) = (self.proxies, self.proxies.touched());
        match mode {
            CompareMode::All => {
                self.candidates.compact();
                let leavers = &proxies.leavers;
                let has_left = |&[a, b]: &[u32; 2]| leavers.contains(a) | leavers.contains(b);
                // Which ones overlap is practically random, so there is no branch on it, only on whether any of many has toggled.
                self.turn(COMPARED, |rows| match leavers.len() {
                    0 => proxies.toggled(rows),
                    _ => gather(rows.pairs, has_left) | proxies.toggled(rows),
                });
                work.compared = self.candidates.rows();
                self.candidates.fill_tombstones();
            }
            CompareMode::Picked { lists_are_missed } => {
                work.picked = self.candidates.rows();
                work.compared = self.turn_those_of(touched, |rows, listed| {
                    gather(rows.pairs, |&pair| listed.has_one(pair))
                });
                if lists_are_missed {
                    self.candidates.lists.state.missed += 1;
                }
            }
            CompareMode::Listed => {
                work.walked = touched.len();
                if !self.candidates.lists.state.are_made {
                    self.candidates.make_lists(proxies.len());
                }
                let mut lists = std::mem::take(&mut self.candidates.lists);
                for &slot in proxies.leavers.slots() {
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
        self.turn_those_of(revolumed, |rows, listed| {
            proxies.met_of_near(rows, |pair| listed.has_one(pair))
        });
    }

    /// Asks the rows that are picked from each 64, given which pairs have one of these slots, and applies the answers. Returns how many
    /// were picked, tombstones included.
    fn turn_those_of(
        &mut self,
        listed: &[u32],
        pick: impl Fn(Rows<'_>, Lookup<'_>) -> u64 + Send + Sync,
    ) -> usize {
        let mut slots = std::mem::take(&mut self.candidates.slots);
        slots.insert_all(listed, self.proxies.len());
        let lookup = slots.lookup();
        // Each candidate has two slots.
        let share_picked = (2 * listed.len() as u64).min(self.proxies.len() as u64);
        let price = PICKED + COMPARED * share_picked / self.proxies.len().max(1) as u64;
        let picked = self.turn(price, |rows| pick(rows, lookup));
        slots.clear_around(listed);
        self.candidates.slots = slots;
        picked
    }

    /// Asks the rows that are picked from each 64, and applies the answers. Returns how many were picked, tombstones included.
    fn turn(&mut self, price: u64, pick: impl Fn(Rows<'_>) -> u64 + Send + Sync) -> usize {
        let mut dues = std::mem::take(&mut self.candidates.dues);
        if self.proxies.volumes.have_odometers() {
            dues.resize(self.candidates.rows(), Due::default());
        }
        let mut parts = std::mem::take(&mut self.candidates.turns);
        let rows = self.candidates.rows();
        let section = Section::of(rows, self.proxies.volumes.price(price));
        let count = section.parts();
        parts.resize_with(count, Turns::default);
        for (i, part) in parts.iter_mut().enumerate() {
            // Whole words, so that threads pick as one does.
            let [start, end] = [i, i + 1].map(|i| 64 * start_of_part(i, count, rows.div_ceil(64)));
            part.rows = start..end.min(rows);
        }
        let (candidates, observer) = (&*self.candidates, &*self.observer);
        let mut rest = &mut dues[..];
        let with_dues = parts.iter_mut().map(|part| {
            let count = part.rows.len().min(rest.len());
            let (dues, others) = std::mem::take(&mut rest).split_at_mut(count);
            rest = others;
            (part, dues)
        });
        let mut with_dues: Vec<_> = with_dues.collect();
        section.for_each(&mut with_dues, |(part, dues)| {
            part.ask(candidates, dues, self.proxies, observer, &pick);
        });
        self.candidates.dues = dues;
        for &Turn { row, state } in parts.iter().flat_map(|part| &part.turns) {
            match state {
                Some(state) => self.set_state(row, state),
                None => self.retire(row),
            }
        }
        let picked = parts.iter().map(|part| part.picked).sum();
        self.candidates.turns = parts;
        picked
    }

    /// Brings a row up to date. Returns whether there is a candidate in it.
    #[inline(always)]
    fn compare_row(&mut self, row: usize) -> bool {
        let Some(pair) = self.candidates.get(row) else {
            return false;
        };
        let former = self.candidates.states[row];
        let state = next_state(self.proxies, &*self.observer, pair, former, None);
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
            // The pairs of removed proxies end without an event.
            PairState::Held if proxies.are_left(pair) => candidates.retired.insert(pair),
            PairState::Held => {}
        }
    }
}
