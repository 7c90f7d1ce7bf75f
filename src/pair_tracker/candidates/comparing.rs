//! Brings candidates up to date with the proxies, and reports which pairs begin and end.

use super::turns::{Found, Next, Turn};
use super::{Candidates, TOMBSTONE};
use crate::bit_set::{Lookup, gather, ones};
use crate::pair_tracker::pair_state::{PairState, near_and_held};
use crate::pair_tracker::policy::are_most_touched;
use crate::pair_tracker::proxies::{Proxies, Rows};
use crate::pair_tracker::{FilterKey, PairChange, PairObserver, VolumeSource};
use crate::parallel::Section;
use crate::real::Real;
use crate::tuning::prices::{COMPARED, HELD, PICKED};

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
        candidates.states.clear();
        candidates.held_count = 0;
        candidates.overlapping_count = 0;
        candidates.tombstones = 0;
        candidates.lists.forget();
        self.keep_forbidden(found);
        self.hold_new(found);
        self.candidates.retired.free_if_large();
        std::mem::swap(&mut self.candidates.pairs, found);
        found.clear();
        self.answer_unread();
    }

    /// Adds the candidates that were `found`, and empties that list.
    pub(in crate::pair_tracker) fn extend(&mut self, found: &mut Vec<[u32; 2]>) {
        self.keep_forbidden(found);
        self.hold_new(found);
        let Candidates { pairs, lists, .. } = &mut *self.candidates;
        let first = pairs.len();
        pairs.append(found);
        lists.extend(pairs, first, self.proxies.len());
        self.answer_unread();
        self.candidates.fill_tombstones();
    }

    /// Reads the volumes of the candidates that could not be answered without, and answers them.
    fn answer_unread(&mut self) {
        let mut unread = std::mem::take(&mut self.candidates.unread);
        let pairs = unread.iter().map(|&row| self.candidates.pairs[row]);
        self.proxies
            .volumes
            .pull(&mut pairs.flatten().collect(), self.source);
        for row in unread.drain(..) {
            self.compare_row(row, false);
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

    /// Appends the states of candidates that were found, and reports which pairs begin. Retired pairs that were not found end.
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
                ..Found::default()
            })
            .collect();
        let asking = &*self;
        section.for_each(&mut parts, |part| asking.ask_found(part));
        for (start, found) in (first..).step_by(pairs_a_part).zip(parts) {
            let unread = found.unread.into_iter().map(|i| start + i);
            self.candidates.unread.extend(unread);
            for pair in found.near {
                self.proxies.volumes.note_near(pair, true);
            }
            self.candidates.held_count += found.held_count;
            self.candidates.overlapping_count += found.overlapping_count;
            for place in found.taken {
                self.candidates.retired.take(place);
            }
            for pair in found.strangers {
                self.candidates.note_overlap(pair);
            }
            for change in found.changed {
                self.observer.report(change);
            }
        }
        self.candidates.states = states;
        let retired = &mut self.candidates.retired;
        retired.drain(|pair| self.observer.report(PairChange::Deleted(pair)));
    }

    /// Brings the candidates of touched proxies, and of those with another volume, up to date, and retires the candidates of leavers.
    ///
    /// If most proxies were touched, it goes through all candidates. Otherwise it picks theirs out of all, which is cheap per candidate, or
    /// walks their lists, which waits for memory at each step and so is for very few proxies.
    pub(in crate::pair_tracker) fn compare(&mut self) {
        let notes = std::mem::take(&mut self.proxies.notes);
        let (touched, revolumed) = (&notes.touched, &notes.revolumed);
        if !touched.is_empty() && are_most_touched(touched.len(), self.proxies.len()) {
            self.compare_all();
        } else {
            self.compare_those_of(touched, |_, rows, listed| {
                gather(rows.pairs, |&pair| listed.has_one(pair))
            });
            // Now, because rows may move before the lists of other slots are walked.
            self.answer_unread();
            // The boxes of these slots stay, so the pairs that are held stay too.
            self.compare_those_of(revolumed, |proxies, rows, listed| {
                proxies.met_of_near(rows, |pair| listed.has_one(pair))
            });
        }
        self.proxies.notes = notes;
    }

    /// Brings all candidates up to date, in order.
    fn compare_all(&mut self) {
        self.candidates.compact();
        // Which boxes overlap is practically random, so there is no branch on it, only on whether any of many has toggled.
        self.turn(COMPARED, |proxies, rows| {
            let leavers = &proxies.leavers;
            let has_left = |&[a, b]: &[u32; 2]| leavers.contains(a) | leavers.contains(b);
            match leavers.len() {
                0 => proxies.toggled(rows),
                _ => gather(rows.pairs, has_left) | proxies.toggled(rows),
            }
        });
        self.candidates.are_turned = true;
    }

    /// Brings the candidates of these slots up to date: those in their lists, or the rows that are picked from each 64, given which pairs
    /// have one of the slots.
    fn compare_those_of(
        &mut self,
        listed: &[u32],
        pick: impl Fn(&Proxies<R, D, K>, Rows<'_>, Lookup<'_>) -> u64 + Send + Sync,
    ) {
        if listed.is_empty() {
            return;
        }
        let count = self.proxies.len();
        if self.candidates.walks_lists(listed.len(), count) {
            let mut lists = std::mem::take(&mut self.candidates.lists);
            // Leavers first: then no other row needs to be asked whether it has one.
            for slot in self.proxies.leavers.slots().to_vec() {
                lists.walk(slot, |row| self.compare_row(row, true));
            }
            for &slot in listed {
                lists.walk(slot, |row| self.compare_row(row, false));
            }
            self.candidates.lists = lists;
            return;
        }
        let mut slots = std::mem::take(&mut self.candidates.slots);
        slots.insert_all(listed, count);
        let lookup = slots.lookup();
        // Each candidate has two slots.
        let share_picked = (2 * listed.len()).min(count) as u64;
        let price = PICKED + COMPARED * share_picked / count.max(1) as u64;
        self.turn(price, |proxies, rows| pick(proxies, rows, lookup));
        slots.clear_around(listed);
        self.candidates.slots = slots;
    }

    /// Asks the rows that are picked from each 64, and applies the answers.
    fn turn(
        &mut self,
        price: u64,
        pick: impl Fn(&Proxies<R, D, K>, Rows<'_>) -> u64 + Send + Sync,
    ) {
        let mut parts = std::mem::take(&mut self.candidates.turns);
        let rows = self.candidates.rows();
        let section = Section::of(rows, self.proxies.volumes.price(price));
        let count = section.parts();
        parts.resize_with(count, Vec::new);
        // Whole words, so that threads pick as one does.
        let rows_a_part = 64 * rows.div_ceil(64).div_ceil(count).max(1);
        let asked = parts.iter_mut().enumerate().map(|(i, turns)| {
            let [start, end] = [i, i + 1].map(|i| rows.min(i * rows_a_part));
            (start..end, turns)
        });
        let mut asked: Vec<_> = asked.collect();
        let asking = &*self;
        section.for_each(&mut asked, |(rows, turns)| {
            asking.ask(rows.clone(), turns, |rows| pick(asking.proxies, rows));
        });
        for &turn in parts.iter().flatten() {
            self.apply(turn);
        }
        self.candidates.turns = parts;
    }

    /// Brings a row up to date, or retires its candidate. Returns whether there is a candidate in it.
    #[inline(always)]
    fn compare_row(&mut self, row: usize, has_left: bool) -> bool {
        let Some(pair) = self.candidates.get(row) else {
            return false;
        };
        let former = self.candidates.states[row];
        let next = match has_left {
            true => Next::Gone,
            false => self.next(pair, former),
        };
        if next != Next::Is(former) {
            self.apply(Turn { row, next });
        }
        next != Next::Gone
    }

    /// Changes a row: sets its state and reports if a pair begins or ends, or puts a tombstone in place of the candidate.
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
        candidates.pairs[row] = [TOMBSTONE; 2];
        candidates.tombstones += 1;
        match former {
            PairState::Near if proxies.is_forbidden(pair) => candidates.forbidden.push(pair),
            // The pairs of removed proxies end without an event.
            PairState::Held if proxies.both_existed(pair) => candidates.retired.insert(pair),
            _ => {}
        }
    }
}
