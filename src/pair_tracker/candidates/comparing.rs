//! Brings candidates up to date with the proxies, and reports which pairs begin and end. They are asked in parts, by several threads if there
//! are many, and the answers are applied in order.

use std::ops::Range;

use super::Candidates;
use crate::bit_set::{gather, ones};
use crate::pair_tracker::pair_state::{PairState, near_and_held};
use crate::pair_tracker::policy::are_most_touched;
use crate::pair_tracker::proxies::{Proxies, Rows};
use crate::pair_tracker::{FilterKey, PairChange, PairObserver, VolumeSource};
use crate::parallel::Section;
use crate::real::Real;
use crate::tuning::prices::{COMPARED, HELD, PICKED};

/// The change of a row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    row: usize,
    next: Next,
}

/// What becomes of a candidate.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Next {
    /// It is in this state.
    Is(PairState),
    /// It is asked again once its volumes have been read.
    Unread,
    /// It is retired.
    Gone,
}

/// The candidates of an update, the proxies that decide which of them are held, and the receiver of the changes.
pub(in crate::pair_tracker) struct Comparing<'a, R, const D: usize, K, O, S> {
    pub(in crate::pair_tracker) candidates: &'a mut Candidates,
    pub(in crate::pair_tracker) proxies: &'a mut Proxies<R, D, K>,
    pub(in crate::pair_tracker) observer: &'a mut O,
    pub(in crate::pair_tracker) source: &'a S,
}

impl<R: Real, const D: usize, K: FilterKey, O: PairObserver, S: VolumeSource<R, D>>
    Comparing<'_, R, D, K, O, S>
{
    /// Replaces all candidates by those that were `found`. Leaves that list empty, with the memory of the former candidates.
    pub(in crate::pair_tracker) fn replace(&mut self, found: &mut Vec<[u32; 2]>) {
        let (candidates, proxies) = (&mut *self.candidates, &mut *self.proxies);
        proxies.volumes.forget_near();
        let proxies = &*proxies;
        let (pairs, retired) = (&candidates.pairs, &mut candidates.retired);
        retired.reserve(candidates.held_count);
        candidates.answers.ask(pairs.len(), COMPARED, |rows| {
            let [_, held] = near_and_held(&candidates.states[rows.clone()]);
            let existed = |i: usize| proxies.both_existed(pairs[rows.start + i]);
            ones(held).fold(0, |word, i| word | u64::from(existed(i)) << i)
        });
        let held = candidates.answers.iter();
        held.for_each(|row| retired.insert(pairs[row]));
        if proxies.are_rekeyed {
            let forbidden = candidates.near().filter(|&pair| proxies.is_forbidden(pair));
            candidates.forbidden = forbidden.collect();
        }
        candidates.pairs.clear();
        candidates.states.clear();
        candidates.held_count = 0;
        candidates.overlapping_count = 0;
        candidates.cool();
        self.extend(found);
        self.candidates.retired.free_if_large();
    }

    /// Adds the candidates that were `found`, and empties that list. Retired pairs that were not found end.
    pub(in crate::pair_tracker) fn extend(&mut self, found: &mut Vec<[u32; 2]>) {
        self.keep_forbidden(found);
        let candidates = &mut *self.candidates;
        let first = candidates.pairs.len();
        match first {
            0 => std::mem::swap(&mut candidates.pairs, found),
            _ => candidates.pairs.append(found),
        }
        let proxies = &*self.proxies;
        candidates.restore_held(first, |pairs| proxies.overlapping(pairs));
        let observer = &mut *self.observer;
        let retired = &mut candidates.retired;
        retired.drain(|pair| observer.report(PairChange::Deleted(pair)));
        let rows = first..self.candidates.len();
        self.turn(rows, HELD, false, |proxies, rows| proxies.toggled(rows));
        self.answer_unread();
        self.candidates.warm_from(first);
    }

    /// Reads the volumes of the candidates that could not be answered without, and answers them.
    fn answer_unread(&mut self) {
        let mut unread = std::mem::take(&mut self.candidates.unread);
        let pairs = unread.iter().map(|&row| self.candidates.pairs[row]);
        self.proxies
            .volumes
            .pull(&mut pairs.flatten().collect(), self.source);
        for row in unread.drain(..) {
            let former = self.candidates.states[row];
            let next = self.next(self.candidates.pairs[row], former);
            self.apply(Turn { row, next });
        }
        self.candidates.unread = unread;
    }

    /// Appends the forbidden pairs to those that were `found`: a search does not find a pair that its keys have come to forbid, although its
    /// boxes still overlap.
    fn keep_forbidden(&mut self, found: &mut Vec<[u32; 2]>) {
        let (candidates, proxies) = (&mut *self.candidates, &*self.proxies);
        if proxies.are_rekeyed {
            let held = candidates.retired.iter();
            let held = held.filter(|&pair| proxies.is_forbidden(pair));
            let all = held.chain(candidates.forbidden.drain(..));
            found.extend(all.filter(|&pair| proxies.overlap(pair)));
        }
    }

    /// Brings the candidates of touched proxies, and of those with another volume, up to date, and retires the candidates of leavers.
    ///
    /// If most proxies were touched, it goes through all candidates, in order. Otherwise it picks theirs out of those that are not cold.
    pub(in crate::pair_tracker) fn compare(&mut self) {
        let notes = std::mem::take(&mut self.proxies.notes);
        let (touched, revolumed) = (&notes.touched, &notes.revolumed);
        let slots = self.proxies.len();
        if !touched.is_empty() && are_most_touched(touched.len(), slots) {
            // Which boxes overlap is practically random, so there is no branch on it, only on whether any of many has toggled.
            self.turn(0..self.candidates.len(), COMPARED, true, |proxies, rows| {
                let leavers = &proxies.leavers;
                let has_left = |&[a, b]: &[u32; 2]| leavers.contains(a) | leavers.contains(b);
                match leavers.len() {
                    0 => proxies.toggled(rows),
                    _ => gather(rows.pairs, has_left) | proxies.toggled(rows),
                }
            });
        } else {
            let candidates = &mut *self.candidates;
            candidates.warm(touched);
            candidates.warm(revolumed);
            let rows = 0..candidates.first_cold;
            let [mut moved, mut changed] =
                [&mut candidates.slots, &mut candidates.revolumed].map(std::mem::take);
            moved.insert_all(touched, slots);
            changed.insert_all(revolumed, slots);
            let [has_moved, has_changed] = [&moved, &changed].map(|set| set.lookup());
            // Each candidate has two slots.
            let share_picked = (2 * touched.len()).min(slots) as u64;
            let price = PICKED + COMPARED * share_picked / slots.max(1) as u64;
            self.turn(rows, price, true, |proxies, rows| {
                let picked = gather(rows.pairs, |&pair| has_moved.has_one(pair));
                // The boxes of the others stay, so their pairs that are held stay too.
                match revolumed.is_empty() {
                    true => picked,
                    false => picked | proxies.met_of_near(rows, |pair| has_changed.has_one(pair)),
                }
            });
            moved.clear_around(touched);
            changed.clear_around(revolumed);
            (self.candidates.slots, self.candidates.revolumed) = (moved, changed);
        }
        self.proxies.notes = notes;
        self.answer_unread();
        self.candidates.remove_gone();
    }

    /// Asks the rows that are picked from each 64 of a range, and applies the answers. With `retires`, the candidates of leavers are retired.
    fn turn(
        &mut self,
        rows: Range<usize>,
        price: u64,
        retires: bool,
        pick: impl Fn(&Proxies<R, D, K>, Rows<'_>) -> u64 + Send + Sync,
    ) {
        let mut parts = std::mem::take(&mut self.candidates.turns);
        let section = Section::of(rows.len(), self.proxies.volumes.price(price));
        let count = section.parts();
        parts.resize_with(count, Vec::new);
        // Whole words, so that threads pick as one does.
        let rows_a_part = 64 * rows.len().div_ceil(64).div_ceil(count).max(1);
        let asked = parts.iter_mut().enumerate().map(|(i, turns)| {
            let [start, end] = [i, i + 1].map(|i| rows.end.min(rows.start + i * rows_a_part));
            (start..end, turns)
        });
        let mut asked: Vec<_> = asked.collect();
        let asking = &*self;
        section.for_each(&mut asked, |(rows, turns)| {
            asking.ask(rows.clone(), retires, turns, |rows| {
                pick(asking.proxies, rows)
            });
        });
        for &turn in parts.iter().flatten() {
            self.apply(turn);
        }
        self.candidates.turns = parts;
    }

    /// Changes a row: sets its state and reports if a pair begins or ends, or retires its candidate.
    #[inline(always)]
    fn apply(&mut self, Turn { row, next }: Turn) {
        let (candidates, proxies) = (&mut *self.candidates, &mut *self.proxies);
        let pair = candidates.pairs[row];
        let state = match next {
            Next::Is(state) => state,
            Next::Unread => return candidates.unread.push(row),
            Next::Gone => PairState::Apart,
        };
        let former = candidates.set_state(row, state);
        let [was_near, is_near] = [former, state].map(|state| state == PairState::Near);
        if was_near != is_near {
            proxies.volumes.note_near(pair, is_near);
        }
        if next != Next::Gone {
            return match (former.is_held(), state.is_held()) {
                (false, true) => self.observer.report(PairChange::Added(pair)),
                (true, false) => self.observer.report(PairChange::Deleted(pair)),
                _ => {}
            };
        }
        candidates.gone.push(row);
        match former {
            PairState::Near if proxies.is_forbidden(pair) => candidates.forbidden.push(pair),
            // The pairs of removed proxies end without an event.
            PairState::Held if proxies.both_existed(pair) => candidates.retired.insert(pair),
            _ => {}
        }
    }

    /// Asks the rows of a range that `pick` picks from each 64, and replaces `turns` by their changes.
    fn ask(
        &self,
        all: Range<usize>,
        retires: bool,
        turns: &mut Vec<Turn>,
        pick: impl Fn(Rows<'_>) -> u64,
    ) {
        turns.clear();
        for start in all.clone().step_by(64) {
            let rows = start..all.end.min(start + 64);
            let picked = pick(Rows {
                pairs: &self.candidates.pairs[rows.clone()],
                states: &self.candidates.states[rows],
            });
            if picked != 0 {
                self.ask_picked(start, picked, retires, turns);
            }
        }
    }

    /// Asks the rows from `start` on whose bit is set.
    #[inline(never)]
    fn ask_picked(&self, start: usize, picked: u64, retires: bool, turns: &mut Vec<Turn>) {
        let leavers = &self.proxies.leavers;
        let has_left = |pair: [u32; 2]| pair.iter().any(|&slot| leavers.contains(slot));
        for i in ones(picked) {
            let row = start + i;
            let pair = self.candidates.pairs[row];
            let former = self.candidates.states[row];
            let next = match retires && has_left(pair) {
                true => Next::Gone,
                false => self.next(pair, former),
            };
            if next != Next::Is(former) {
                turns.push(Turn { row, next });
            }
        }
    }

    /// What becomes of a candidate that had this state. It is gone if its boxes have parted and its keys forbid it.
    #[inline(always)]
    fn next(&self, pair: [u32; 2], former: PairState) -> Next {
        match self.proxies.overlap(pair) {
            true => self.next_of_overlapping(pair, former.is_held()),
            false if self.proxies.is_forbidden(pair) => Next::Gone,
            false => Next::Is(PairState::Apart),
        }
    }

    /// What becomes of a pair whose boxes overlap. A pair that would end by its volumes alone stays while its contact is active.
    #[inline(always)]
    fn next_of_overlapping(&self, pair: [u32; 2], was_held: bool) -> Next {
        match self.proxies.holds(pair, was_held) {
            None => Next::Unread,
            Some(false) if !(was_held && self.observer.is_active(pair)) => {
                Next::Is(PairState::Near)
            }
            Some(_) => Next::Is(PairState::Held),
        }
    }
}
