//! The array of candidates, with a tombstone in place of each that is gone.

use super::proxies::{Proxies, overlap};
use super::retired::RetiredPairs;
use super::state::PairState;
use crate::bit_set::BitSet;
use crate::pair_tracker::{FilterKey, PairChange};
use crate::slot_set::SlotSet;
use crate::tuning::update::SPARSE_FROM_ONE_IN;
use crate::{Aabb, Real};

/// In place of a slot: the candidate is gone.
const TOMBSTONE: u32 = u32::MAX;

/// The candidates by rows, and the state of each.
#[derive(Clone, Debug, Default)]
pub(super) struct CandidateArray {
    /// By slots, smaller first; two tombstones where the candidate is gone.
    pairs: Vec<[u32; 2]>,
    /// By row.
    states: Vec<PairState>,
    held_count: usize,
    /// Those whose boxes overlap, held or not.
    overlapping_count: usize,
    tombstones: usize,
    /// Held pairs that were retired in this update, if there are volumes.
    retired: RetiredPairs,
    /// Scratch: answers about rows, or about what was found.
    answers: BitSet,
}

impl CandidateArray {
    /// These candidates, whose boxes all overlap, and of which those in `near` are not held.
    ///
    /// # Errors
    /// If a pair in `near` is not among them, or is there twice.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn overlapping(
        mut pairs: Vec<[u32; 2]>,
        near: Vec<[u32; 2]>,
    ) -> Result<Self, &'static str> {
        pairs.sort_unstable();
        let mut states = vec![PairState::Held; pairs.len()];
        for pair in &near {
            let row = pairs.binary_search(pair).ok();
            match row.map(|row| &mut states[row]) {
                Some(state) if state.is_held() => *state = PairState::Near,
                _ => return Err("snapshot: a pair is near although its boxes do not overlap"),
            }
        }
        Ok(Self {
            held_count: pairs.len() - near.len(),
            overlapping_count: pairs.len(),
            pairs,
            states,
            ..Self::default()
        })
    }

    /// The pair in a row, if it is not gone.
    #[inline(always)]
    pub(super) fn get(&self, row: usize) -> Option<[u32; 2]> {
        let pair = self.pairs[row];
        (pair[0] != TOMBSTONE).then_some(pair)
    }

    /// The rows, tombstones included.
    pub(super) fn rows(&self) -> usize {
        self.pairs.len()
    }

    pub(super) fn len(&self) -> usize {
        self.pairs.len() - self.tombstones
    }

    pub(super) fn held_count(&self) -> usize {
        self.held_count
    }

    pub(super) fn overlapping_count(&self) -> usize {
        self.overlapping_count
    }

    pub(super) fn is_sparse(&self) -> bool {
        self.tombstones > self.pairs.len() / SPARSE_FROM_ONE_IN
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let pairs = self.pairs.iter().copied();
        pairs.filter(|pair| pair[0] != TOMBSTONE)
    }

    pub(super) fn held(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let all = self.pairs.iter().zip(&self.states);
        all.filter_map(|(&pair, &state)| state.is_held().then_some(pair))
    }

    /// The rows whose boxes overlap and that are not held, with their pairs.
    pub(super) fn near(&self) -> impl Iterator<Item = (usize, [u32; 2])> + '_ {
        let all = self.pairs.iter().zip(&self.states).enumerate();
        all.filter_map(|(row, (&pair, &state))| (state == PairState::Near).then_some((row, pair)))
    }

    /// Makes `found` the candidates, and leaves the memory of the former ones there.
    pub(super) fn replace<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        found: &mut Vec<[u32; 2]>,
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        let Self {
            pairs,
            states,
            retired,
            answers,
            ..
        } = self;
        if proxies.has_volumes() {
            retired.reserve(self.held_count);
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
        self.held_count = 0;
        self.overlapping_count = 0;
        self.tombstones = 0;
        let pairs = std::mem::take(pairs);
        self.hold_new(&pairs, proxies, report);
        self.retired.free_if_large();
        self.pairs = pairs;
    }

    /// Adds candidates.
    pub(super) fn extend<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        found: &[[u32; 2]],
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        self.hold_new(found, proxies, report);
        self.pairs.extend_from_slice(found);
    }

    fn hold_new<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        found: &[[u32; 2]],
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        let Self {
            states,
            retired,
            held_count,
            overlapping_count,
            answers,
            ..
        } = self;
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

    /// Makes `rows` the rows with a picked slot, and possibly some tombstones.
    pub(super) fn pick(&self, rows: &mut BitSet, is_picked: impl Fn(u32) -> bool + Sync + Send) {
        rows.ask(self.pairs.len(), |range| {
            gather(&self.pairs[range], |&[a, b]| is_picked(a) | is_picked(b))
        });
    }

    /// Brings all rows up to date with the present boxes, and removes the rows of the `escaped`. No row may be a tombstone.
    /// Returns whether rows have moved.
    pub(super) fn compare_all<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        changed: &mut BitSet,
        escaped: &SlotSet,
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) -> bool {
        debug_assert_eq!(self.tombstones, 0);
        let Self { pairs, states, .. } = self;
        // Which ones overlap is practically random, so there is no branch on it, only on whether any of many has turned.
        if escaped.len() == 0 {
            changed.ask(pairs.len(), |rows| {
                proxies.turned(&pairs[rows.clone()], &states[rows])
            });
            for row in changed.iter() {
                self.set_state(
                    row,
                    proxies.state_of(self.pairs[row], self.states[row]),
                    report,
                );
            }
            return false;
        }
        let has_escaped = |&[a, b]: &[u32; 2]| escaped.contains(a) | escaped.contains(b);
        changed.ask(pairs.len(), |rows| {
            let (pairs, states) = (&pairs[rows.clone()], &states[rows]);
            proxies.turned(pairs, states) | gather(pairs, has_escaped)
        });
        let rows = pairs.len();
        for row in changed.iter() {
            if has_escaped(&self.pairs[row]) {
                self.retire(row, proxies, report);
            } else {
                self.set_state(
                    row,
                    proxies.state_of(self.pairs[row], self.states[row]),
                    report,
                );
            }
        }
        // Backwards, so that the row `swap_remove` moves in has already been checked.
        for row in changed.iter_backwards() {
            if self.pairs[row][0] == TOMBSTONE {
                self.pairs.swap_remove(row);
                self.states.swap_remove(row);
            }
        }
        self.tombstones = 0;
        self.pairs.len() < rows
    }

    /// Brings a row up to date with the present boxes.
    #[inline(always)]
    pub(super) fn compare<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        row: usize,
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        if let Some(pair) = self.get(row) {
            let former = self.states[row];
            let state = proxies.state_of(pair, former);
            if state != former {
                self.set_state(row, state, report);
            }
        }
    }

    /// Brings the rows that are near, and that have one of these slots, up to date with the present volumes.
    pub(super) fn compare_near<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        changed: &mut BitSet,
        is_one: impl Fn([u32; 2]) -> bool + Sync + Send,
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        let Self { pairs, states, .. } = self;
        changed.ask(pairs.len(), |rows| {
            proxies.turned_near(&pairs[rows.clone()], &states[rows], &is_one)
        });
        for row in changed.iter() {
            self.set_state(row, PairState::Held, report);
        }
    }

    #[inline(always)]
    fn set_state(&mut self, row: usize, state: PairState, report: &mut impl FnMut(PairChange)) {
        let former = std::mem::replace(&mut self.states[row], state);
        self.overlapping_count += usize::from(state.overlaps());
        self.overlapping_count -= usize::from(former.overlaps());
        match (former.is_held(), state.is_held()) {
            (false, true) => {
                report(PairChange::Added(self.pairs[row]));
                self.held_count += 1;
            }
            (true, false) => {
                report(PairChange::Deleted(self.pairs[row]));
                self.held_count -= 1;
            }
            _ => {}
        }
    }

    /// Puts a tombstone in place of a candidate when one of its proxies has left its fat box or is gone.
    #[inline(always)]
    pub(super) fn retire<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        row: usize,
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        let Some(pair) = self.get(row) else {
            return;
        };
        self.pairs[row] = [TOMBSTONE; 2];
        self.tombstones += 1;
        let state = std::mem::take(&mut self.states[row]);
        self.overlapping_count -= usize::from(state.overlaps());
        if state.is_held() {
            self.held_count -= 1;
            if proxies.has_volumes() {
                if proxies.are_left(pair) {
                    self.retired.insert(pair);
                }
            } else if proxies.has_ended(pair) {
                report(PairChange::Deleted(pair));
            }
        }
    }

    /// Removes the tombstones. Returns whether there were any, so that rows have moved.
    pub(super) fn compact(&mut self) -> bool {
        if self.tombstones == 0 {
            return false;
        }
        let pairs = &self.pairs;
        let mut row = 0;
        self.states.retain(|_| {
            row += 1;
            pairs[row - 1][0] != TOMBSTONE
        });
        self.pairs.retain(|pair| pair[0] != TOMBSTONE);
        self.tombstones = 0;
        true
    }

    /// Panics unless flags and counts are consistent.
    pub(super) fn validate<R: Real, const D: usize>(
        &self,
        now: &[Aabb<R, D>],
        volumes_meet: impl Fn([u32; 2], bool) -> bool,
    ) {
        assert_eq!(self.pairs.len(), self.states.len());
        assert_eq!(self.held().count(), self.held_count);
        let overlapping = self.states.iter().filter(|state| state.overlaps());
        assert_eq!(overlapping.count(), self.overlapping_count);
        assert_eq!(self.iter().count(), self.len());
        for (&pair, &state) in self.pairs.iter().zip(&self.states) {
            let overlaps = pair[0] != TOMBSTONE && overlap(now, pair);
            assert_eq!(state != PairState::Apart, overlaps, "{pair:?} overlaps");
            let is_held = overlaps && volumes_meet(pair, state.is_held());
            assert_eq!(state.is_held(), is_held, "{pair:?} is held, or is not");
        }
    }
}

/// The answers for up to 64 items, the first one lowest. Without a branch, because answers are practically random.
#[inline(always)]
pub(super) fn gather<T>(
    items: impl IntoIterator<Item = T, IntoIter: ExactSizeIterator>,
    ask: impl Fn(T) -> bool,
) -> u64 {
    let items = items.into_iter();
    let unused = 64 - items.len();
    let word = items.fold(0, |word, item| word >> 1 | u64::from(ask(item)) << 63);
    word >> unused
}
