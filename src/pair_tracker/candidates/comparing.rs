//! Brings candidates up to date with the proxies, and reports which pairs begin and end. They are asked in parts, by several threads if there
//! are many, and the answers are applied in order.

use std::ops::Range;

use super::{Candidates, PairState, near_and_held};
use crate::bit_set::{gather, ones};
use crate::pair_tracker::changes::pack;
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
    /// It is retired.
    Gone,
}

/// A row, its state before, which is held if it was retired and found again, and what becomes of it.
pub(super) type RowChange = (usize, PairState, Outcome);

/// The candidates of an update, the proxies that decide which of them are held, and the changes of the pair set.
pub(in crate::pair_tracker) struct Comparing<'a, R, const D: usize, K, C> {
    pub(in crate::pair_tracker) candidates: &'a mut Candidates,
    pub(in crate::pair_tracker) proxies: &'a mut Proxies<R, D, K>,
    pub(in crate::pair_tracker) changes: &'a mut Changes,
    pub(in crate::pair_tracker) colliders: &'a C,
}

impl<R: Real, const D: usize, K: FilterKey, C: Colliders<R, D>> Comparing<'_, R, D, K, C> {
    /// Replaces all candidates by those that were `found`.
    pub(in crate::pair_tracker) fn replace(&mut self, found: Vec<[u32; 2]>) {
        self.proxies.volumes.near.fill(0);
        let candidates = &mut *self.candidates;
        let pairs = std::mem::take(&mut candidates.pairs);
        let states = std::mem::take(&mut candidates.states);
        candidates.retired.reserve(candidates.held_count);
        (candidates.held_count, candidates.overlapping_count) = (0, 0);
        candidates.first_cold = 0;
        candidates.warm.clear();
        for (pairs, states) in pairs.chunks(64).zip(states.chunks(64)) {
            let [near, held] = near_and_held(states);
            let asked = held | if self.proxies.are_rekeyed { near } else { 0 };
            ones(asked).for_each(|i| self.retire(pairs[i], states[i]));
        }
        drop((pairs, states));
        self.extend(found);
        let candidates = &mut *self.candidates;
        candidates.retired.shrink_to(KEEP_SCRATCH_UP_TO);
        candidates.unread.shrink_to(KEEP_SCRATCH_UP_TO);
        let is_small = |changes: &Vec<_>| changes.capacity() <= KEEP_SCRATCH_UP_TO;
        candidates.row_changes.retain(is_small);
    }

    /// Adds the candidates that were `found`. Those that were retired and still overlap are among them, or forbidden.
    pub(in crate::pair_tracker) fn extend(&mut self, mut found: Vec<[u32; 2]>) {
        let candidates = &mut *self.candidates;
        found.append(&mut candidates.forbidden);
        let first = candidates.pairs.len();
        match first {
            0 => candidates.pairs = found,
            _ => candidates.pairs.append(&mut found),
        }
        let rows = first..candidates.pairs.len();
        candidates.states.resize(rows.end, PairState::Apart);
        self.ask_and_apply(rows, HELD, true, |proxies, pairs, _| {
            proxies.overlapping(pairs)
        });
        self.candidates.retired.clear();
        self.answer_unread();
        self.candidates.warm_from(first);
    }

    /// Reads the volumes of the candidates that could not be answered without, and answers them.
    fn answer_unread(&mut self) {
        let mut unread = std::mem::take(&mut self.candidates.unread);
        let pairs = unread.iter().map(|&row| self.candidates.pairs[row]);
        let mut slots = pairs.flatten().collect();
        self.proxies.volumes.pull(&mut slots, self.colliders);
        for row in unread.drain(..) {
            let former = self.candidates.states[row];
            let outcome = self.outcome(self.candidates.pairs[row], former);
            self.apply((row, former, outcome));
        }
        self.candidates.unread = unread;
    }

    /// Brings the candidates of touched proxies, and of those with another volume, up to date, and retires the candidates of leavers.
    pub(in crate::pair_tracker) fn compare(&mut self) {
        let (candidates, proxies) = (&mut *self.candidates, &*self.proxies);
        let (touched, slots) = (&proxies.notes.touched, proxies.len());
        if !touched.is_empty() && are_many_touched(touched.len(), slots) {
            let rows = 0..candidates.len();
            self.ask_and_apply(rows, COMPARED, false, |proxies, pairs, states| {
                let leavers = &proxies.leavers;
                let has_left = |&pair: &[u32; 2]| leavers.has_any(pair);
                // Which boxes overlap is practically random, so there is no branch on it, only on whether any of many has toggled.
                match leavers.len() {
                    0 => proxies.toggled(pairs, states),
                    _ => gather(pairs, has_left) | proxies.toggled(pairs, states),
                }
            });
        } else {
            candidates.warm_up(touched);
            candidates.warm_up(&proxies.notes.revolumed);
            // Each candidate has two slots.
            let share_picked = (2 * touched.len()).min(slots) as u64;
            let price = PICKED + COMPARED * share_picked / slots as u64;
            let rows = 0..candidates.first_cold;
            self.ask_and_apply(rows, price, false, |proxies, pairs, states| {
                let picked = gather(pairs, |&pair| proxies.touched.has_any(pair));
                // The boxes of the others stay, so their pairs that are held stay too.
                match proxies.revolumed.len() {
                    0 => picked,
                    _ => picked | proxies.changed_of_near(pairs, states),
                }
            });
        }
        self.answer_unread();
        self.candidates.remove_gone();
    }

    /// Asks the rows of a range that `pick` picks from each 64, in parts, and applies the answers. `are_found` says whether a search has found
    /// them, in place of those that were retired.
    fn ask_and_apply(
        &mut self,
        rows: Range<usize>,
        price: u64,
        are_found: bool,
        pick: impl Fn(&Proxies<R, D, K>, &[[u32; 2]], &[PairState]) -> u64 + Send + Sync,
    ) {
        let mut parts = std::mem::take(&mut self.candidates.row_changes);
        let section = Section::of(rows.len(), self.proxies.volumes.price(price));
        let count = section.parts();
        parts.resize_with(count, Vec::new);
        // Whole words, so that threads pick as one does.
        let rows_a_part = 64 * rows.len().div_ceil(64).div_ceil(count).max(1);
        let starts = rows.clone().step_by(rows_a_part);
        let mut asked: Vec<_> = starts.zip(&mut parts).collect();
        let asking = &*self;
        section.for_each(&mut asked, |(start, changes)| {
            let end = rows.end.min(*start + rows_a_part);
            for start in (*start..end).step_by(64) {
                let word = start..end.min(start + 64);
                let Candidates { pairs, states, .. } = &*asking.candidates;
                let picked = pick(asking.proxies, &pairs[word.clone()], &states[word]);
                if picked != 0 {
                    asking.ask(start, picked, are_found, changes);
                }
            }
        });
        for change in parts.iter_mut().flat_map(|changes| changes.drain(..)) {
            self.apply(change);
        }
        self.candidates.row_changes = parts;
    }

    /// Asks the rows from `start` on whose bit is set. Those of leavers are retired, unless a search has found them.
    #[inline(never)]
    fn ask(&self, start: usize, picked: u64, are_found: bool, changes: &mut Vec<RowChange>) {
        for i in ones(picked) {
            let row = start + i;
            let pair = self.candidates.pairs[row];
            if are_found {
                let was_held = self.candidates.retired.contains(&pack(pair));
                let former = [PairState::Apart, PairState::Held][usize::from(was_held)];
                changes.push((row, former, self.outcome_if_overlapping(pair, was_held)));
                continue;
            }
            let former = self.candidates.states[row];
            let outcome = match self.proxies.leavers.has_any(pair) {
                true => Outcome::Gone,
                false => self.outcome(pair, former),
            };
            if outcome != Outcome::Is(former) {
                changes.push((row, former, outcome));
            }
        }
    }

    /// Changes a row: sets its state and reports if a pair begins or ends, or retires its candidate.
    #[inline(always)]
    fn apply(&mut self, (row, former, outcome): RowChange) {
        let (candidates, proxies) = (&mut *self.candidates, &mut *self.proxies);
        let pair = candidates.pairs[row];
        if candidates.states[row] != former {
            candidates.set_state(row, former);
        }
        let state = match outcome {
            Outcome::Is(state) => state,
            Outcome::Unread => return candidates.unread.push(row),
            Outcome::Gone => PairState::Apart,
        };
        candidates.set_state(row, state);
        let [was_near, is_near] = [former, state].map(|state| state == PairState::Near);
        if was_near != is_near {
            proxies.volumes.note_near(pair, is_near);
        }
        if outcome == Outcome::Gone {
            candidates.gone.push(row);
            return self.retire(pair, former);
        }
        let [was_held, is_held] = [former, state].map(|state| state == PairState::Held);
        if was_held != is_held {
            self.changes.push(is_held, pair);
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
            (PairState::Held, false) => self.changes.push(false, pair),
            _ => {}
        }
        if overlap && proxies.is_forbidden(pair) {
            candidates.forbidden.push(pair);
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

    /// What becomes of a pair whose boxes overlap. A pair that would end by its volumes alone stays while its contact is active. A former broad
    /// phase may have reported a pair of a new proxy.
    #[inline(always)]
    fn outcome_if_overlapping(&self, pair: [u32; 2], was_held: bool) -> Outcome {
        let may_be_active = || was_held || !self.proxies.both_existed(pair);
        match self.proxies.holds(pair, was_held) {
            None => Outcome::Unread,
            Some(false) if !(may_be_active() && self.colliders.is_active(pair)) => {
                Outcome::Is(PairState::Near)
            }
            Some(_) => Outcome::Is(PairState::Held),
        }
    }
}
