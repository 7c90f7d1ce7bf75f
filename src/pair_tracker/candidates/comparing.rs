//! Brings candidates up to date with the proxies, and reports which pairs begin and end. They are asked in parts, by several threads if there
//! are many, and the answers are applied in order.

use std::ops::Range;

use super::Candidates;
use crate::bit_set::{gather, ones};
use crate::pair_tracker::changes::pack;
use crate::pair_tracker::pair_state::{PairState, near_and_held};
use crate::pair_tracker::policy::are_many_touched;
use crate::pair_tracker::proxies::Proxies;
use crate::pair_tracker::{Changes, Colliders, FilterKey};
use crate::parallel::Section;
use crate::real::Real;
use crate::tuning::prices::{COMPARED, HELD, PICKED};
use crate::tuning::update::KEEP_SCRATCH_UP_TO;

/// What becomes of a candidate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Outcome {
    /// It is in this state.
    Is(PairState),
    /// It is asked again once its volumes have been read.
    Unread,
    /// It was held and retired. If it does not stay held, another change of the row follows.
    FoundAgain,
    /// It is retired.
    Gone,
}

/// The candidates of an update, the proxies that decide which of them are held, and the changes of the pair set.
pub(in crate::pair_tracker) struct Comparing<'a, R, const D: usize, K, C> {
    pub(in crate::pair_tracker) candidates: &'a mut Candidates,
    pub(in crate::pair_tracker) proxies: &'a mut Proxies<R, D, K>,
    pub(in crate::pair_tracker) changes: &'a mut Changes,
    pub(in crate::pair_tracker) colliders: &'a C,
}

impl<R: Real, const D: usize, K: FilterKey, C: Colliders<R, D>> Comparing<'_, R, D, K, C> {
    /// Replaces all candidates by those that were `found`. Leaves that list empty, with the memory of the former candidates.
    pub(in crate::pair_tracker) fn replace(&mut self, found: &mut Vec<[u32; 2]>) {
        self.proxies.volumes.near.fill(0);
        let (candidates, proxies) = (&mut *self.candidates, &*self.proxies);
        let mut pairs = std::mem::take(&mut candidates.pairs);
        let mut states = std::mem::take(&mut candidates.states);
        let mut answers = std::mem::take(&mut candidates.answers);
        answers.fill_from(pairs.len(), COMPARED, |rows| {
            let [near, held] = near_and_held(&states[rows.clone()]);
            let asked = held | if proxies.are_rekeyed { near } else { 0 };
            let existed = |i: usize| proxies.both_existed(pairs[rows.start + i]);
            ones(asked).fold(0, |word, i| word | u64::from(existed(i)) << i)
        });
        let held = candidates.held_count;
        candidates.retired.reserve(held);
        for row in answers.iter() {
            self.retire(pairs[row], states[row]);
        }
        pairs.clear();
        states.clear();
        let candidates = &mut *self.candidates;
        (candidates.pairs, candidates.states, candidates.answers) = (pairs, states, answers);
        (candidates.held_count, candidates.overlapping_count) = (0, 0);
        candidates.first_cold = 0;
        candidates.warm.clear();
        self.extend(found);
        self.candidates.retired.shrink_to(KEEP_SCRATCH_UP_TO);
    }

    /// Adds the candidates that were `found`, and empties that list. Those that were retired and still overlap are among them, or forbidden.
    pub(in crate::pair_tracker) fn extend(&mut self, found: &mut Vec<[u32; 2]>) {
        let candidates = &mut *self.candidates;
        found.append(&mut candidates.forbidden);
        let first = candidates.pairs.len();
        match first {
            0 => std::mem::swap(&mut candidates.pairs, found),
            _ => candidates.pairs.append(found),
        }
        let rows = first..candidates.pairs.len();
        candidates.states.resize(rows.end, PairState::Apart);
        self.ask_and_apply(rows, HELD, Self::ask_found);
        self.candidates.retired.clear();
        self.answer_unread();
        self.candidates.warm_from(first);
    }

    /// Reads the volumes of the candidates that could not be answered without, and answers them.
    fn answer_unread(&mut self) {
        let mut unread = std::mem::take(&mut self.candidates.unread);
        let pairs = unread.iter().map(|&row| self.candidates.pairs[row]);
        self.proxies
            .volumes
            .pull(&mut pairs.flatten().collect(), self.colliders);
        for row in unread.drain(..) {
            let former = self.candidates.states[row];
            let outcome = self.outcome(self.candidates.pairs[row], former);
            self.apply((row, outcome));
        }
        self.candidates.unread = unread;
    }

    /// Brings the candidates of touched proxies, and of those with another volume, up to date, and retires the candidates of leavers.
    pub(in crate::pair_tracker) fn compare(&mut self) {
        let notes = std::mem::take(&mut self.proxies.notes);
        let (touched, revolumed) = (&notes.touched, &notes.revolumed);
        let slots = self.proxies.len();
        if !touched.is_empty() && are_many_touched(touched.len(), slots) {
            // Which boxes overlap is practically random, so there is no branch on it, only on whether any of many has toggled.
            let pick = |proxies: &Proxies<R, D, K>, pairs: &[_], states: &[_]| {
                let leavers = &proxies.leavers;
                let has_left = |&pair: &[u32; 2]| leavers.has_any(pair);
                match leavers.len() {
                    0 => proxies.toggled(pairs, states),
                    _ => gather(pairs, has_left) | proxies.toggled(pairs, states),
                }
            };
            let rows = 0..self.candidates.len();
            self.ask_and_apply(rows, COMPARED, |all, rows, to| all.ask(rows, to, pick));
        } else {
            let candidates = &mut *self.candidates;
            candidates.warm(touched);
            candidates.warm(revolumed);
            let rows = 0..candidates.first_cold;
            let [mut moved, mut changed] =
                [&mut candidates.slots, &mut candidates.revolumed].map(std::mem::take);
            moved.extend(touched);
            changed.extend(revolumed);
            // Each candidate has two slots.
            let share_picked = (2 * touched.len()).min(slots) as u64;
            let price = PICKED + COMPARED * share_picked / slots.max(1) as u64;
            let pick = |proxies: &Proxies<R, D, K>, pairs: &[_], states: &[_]| {
                let picked = gather(pairs, |&pair| moved.has_any(pair));
                let has_changed = |pair| changed.has_any(pair);
                // The boxes of the others stay, so their pairs that are held stay too.
                match revolumed.is_empty() {
                    true => picked,
                    false => picked | proxies.changed_of_near(pairs, states, has_changed),
                }
            };
            self.ask_and_apply(rows, price, |all, rows, to| all.ask(rows, to, pick));
            moved.clear();
            changed.clear();
            (self.candidates.slots, self.candidates.revolumed) = (moved, changed);
        }
        self.proxies.notes = notes;
        self.answer_unread();
        self.candidates.remove_gone();
    }

    /// Asks a range of rows in parts, and applies the answers, which `ask` appends to a list.
    fn ask_and_apply(
        &mut self,
        rows: Range<usize>,
        price: u64,
        ask: impl Fn(&Self, Range<usize>, &mut Vec<(usize, Outcome)>) + Send + Sync,
    ) {
        let mut parts = std::mem::take(&mut self.candidates.row_changes);
        let section = Section::of(rows.len(), self.proxies.volumes.price(price));
        let count = section.parts();
        parts.resize_with(count, Vec::new);
        // Whole words, so that threads pick as one does.
        let rows_a_part = 64 * rows.len().div_ceil(64).div_ceil(count).max(1);
        let asked = parts.iter_mut().enumerate().map(|(i, changes)| {
            let [start, end] = [i, i + 1].map(|i| rows.end.min(rows.start + i * rows_a_part));
            (start..end, changes)
        });
        let mut asked: Vec<_> = asked.collect();
        let asking = &*self;
        section.for_each(&mut asked, |(rows, changes)| {
            ask(asking, rows.clone(), changes);
        });
        for change in parts.iter_mut().flat_map(|changes| changes.drain(..)) {
            self.apply(change);
        }
        self.candidates.row_changes = parts;
    }

    /// Changes a row: sets its state and reports if a pair begins or ends, or retires its candidate.
    #[inline(always)]
    fn apply(&mut self, (row, outcome): (usize, Outcome)) {
        let (candidates, proxies) = (&mut *self.candidates, &mut *self.proxies);
        let pair = candidates.pairs[row];
        let state = match outcome {
            Outcome::Is(state) => state,
            Outcome::Unread => return candidates.unread.push(row),
            Outcome::FoundAgain => {
                // Its slots are acquainted, and it has not begun now.
                candidates.states[row] = PairState::Held;
                candidates.held_count += 1;
                candidates.overlapping_count += 1;
                return;
            }
            Outcome::Gone => PairState::Apart,
        };
        let former = candidates.set_state(row, state);
        let [was_near, is_near] = [former, state].map(|state| state == PairState::Near);
        if was_near != is_near {
            proxies.volumes.note_near(pair, is_near);
        }
        if outcome == Outcome::Gone {
            candidates.gone.push(row);
            return self.retire(pair, former);
        }
        match [former, state].map(|state| state == PairState::Held) {
            [false, true] => self.changes.add(pair),
            [true, false] => self.changes.delete(pair),
            _ => {}
        }
    }

    /// Retires the candidate of a pair that was in this state. If its boxes still overlap, the search finds it again, unless its keys have come
    /// to forbid it. The pairs of removed proxies end without an event.
    fn retire(&mut self, pair: [u32; 2], former: PairState) {
        let (candidates, proxies) = (&mut *self.candidates, &*self.proxies);
        if former == PairState::Apart || !proxies.both_existed(pair) {
            return;
        }
        let overlap = proxies.overlap(pair);
        match (former, overlap) {
            (PairState::Held, true) => _ = candidates.retired.insert(pack(pair)),
            (PairState::Held, false) => self.changes.delete(pair),
            _ => {}
        }
        if overlap && proxies.is_forbidden(pair) {
            candidates.forbidden.push(pair);
        }
    }

    /// Asks rows that a search has found, in place of those that were retired.
    fn ask_found(&self, rows: Range<usize>, changes: &mut Vec<(usize, Outcome)>) {
        for start in rows.clone().step_by(64) {
            let pairs = &self.candidates.pairs[start..rows.end.min(start + 64)];
            for i in ones(self.proxies.overlapping(pairs)) {
                let row = start + i;
                let was_held = self.candidates.retired.contains(&pack(pairs[i]));
                if was_held {
                    changes.push((row, Outcome::FoundAgain));
                }
                let outcome = self.outcome_if_overlapping(pairs[i], was_held);
                if !was_held || outcome != Outcome::Is(PairState::Held) {
                    changes.push((row, outcome));
                }
            }
        }
    }

    /// Asks the rows of a range that `pick` picks from each 64. Those of leavers are retired.
    fn ask(
        &self,
        all: Range<usize>,
        changes: &mut Vec<(usize, Outcome)>,
        pick: impl Fn(&Proxies<R, D, K>, &[[u32; 2]], &[PairState]) -> u64,
    ) {
        for start in all.clone().step_by(64) {
            let rows = start..all.end.min(start + 64);
            let Candidates { pairs, states, .. } = &*self.candidates;
            let picked = pick(self.proxies, &pairs[rows.clone()], &states[rows]);
            if picked != 0 {
                self.ask_picked(start, picked, changes);
            }
        }
    }

    /// Asks the rows from `start` on whose bit is set.
    #[inline(never)]
    fn ask_picked(&self, start: usize, picked: u64, changes: &mut Vec<(usize, Outcome)>) {
        let leavers = &self.proxies.leavers;
        for i in ones(picked) {
            let row = start + i;
            let pair = self.candidates.pairs[row];
            let former = self.candidates.states[row];
            let outcome = match leavers.has_any(pair) {
                true => Outcome::Gone,
                false => self.outcome(pair, former),
            };
            if outcome != Outcome::Is(former) {
                changes.push((row, outcome));
            }
        }
    }

    /// What becomes of a candidate that had this state. It is gone if its boxes have parted and its keys forbid it.
    #[inline(always)]
    fn outcome(&self, pair: [u32; 2], former: PairState) -> Outcome {
        match self.proxies.overlap(pair) {
            true => self.outcome_if_overlapping(pair, former == PairState::Held),
            false if self.proxies.is_forbidden(pair) => Outcome::Gone,
            false => Outcome::Is(PairState::Apart),
        }
    }

    /// What becomes of a pair whose boxes overlap. A pair that would end by its volumes alone stays while its contact is active.
    #[inline(always)]
    fn outcome_if_overlapping(&self, pair: [u32; 2], was_held: bool) -> Outcome {
        match self.proxies.holds(pair, was_held) {
            None => Outcome::Unread,
            Some(false) if !(was_held && self.colliders.is_active(pair)) => {
                Outcome::Is(PairState::Near)
            }
            Some(_) => Outcome::Is(PairState::Held),
        }
    }
}
