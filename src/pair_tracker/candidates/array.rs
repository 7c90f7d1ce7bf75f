//! The array of candidates, with a tombstone in place of each that is gone.

use super::proxies::{Proxies, overlap};
use super::retired::RetiredPairs;
use crate::bit_set::BitSet;
use crate::pair_tracker::{FilterKey, PairChange};
use crate::slot_set::SlotSet;
use crate::tuning::update::SPARSE_FROM_ONE_IN;
use crate::{Aabb, Real};

/// In place of a slot: the candidate is gone.
const TOMBSTONE: u32 = u32::MAX;

/// The candidates by rows, and whether each is held.
#[derive(Clone, Debug, Default)]
pub(super) struct CandidateArray {
    /// By slots, smaller first; two tombstones where the candidate is gone.
    pairs: Vec<[u32; 2]>,
    /// By row: whether the pair is held, because its boxes overlap and its volumes meet.
    held: Vec<bool>,
    held_count: usize,
    tombstones: usize,
    /// Held pairs that were retired in this update, if there are volumes.
    retired: RetiredPairs,
    /// Scratch: answers about rows, or about what was found.
    answers: BitSet,
}

impl CandidateArray {
    /// The candidates in these rows.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn new<R: Real, const D: usize>(
        rows: impl Iterator<Item = Option<[u32; 2]>>,
        boxes: &[Aabb<R, D>],
    ) -> Self {
        let rows = rows.map(|row| row.unwrap_or([TOMBSTONE; 2]));
        let mut array = Self {
            pairs: rows.collect(),
            ..Self::default()
        };
        let held = |&pair: &[u32; 2]| pair[0] != TOMBSTONE && overlap(boxes, pair);
        array.held = array.pairs.iter().map(held).collect();
        array.held_count = array.held().count();
        array.tombstones = array.rows() - array.iter().count();
        array
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

    pub(super) fn is_sparse(&self) -> bool {
        self.tombstones > self.pairs.len() / SPARSE_FROM_ONE_IN
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let pairs = self.pairs.iter().copied();
        pairs.filter(|pair| pair[0] != TOMBSTONE)
    }

    pub(super) fn held(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let all = self.pairs.iter().zip(&self.held);
        all.filter_map(|(&pair, &is_held)| is_held.then_some(pair))
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
            held,
            retired,
            answers,
            ..
        } = self;
        if proxies.has_volumes() {
            let rows = pairs.iter().zip(held.iter());
            for (&pair, _) in rows.filter(|&(&pair, &is_held)| is_held && proxies.are_left(pair)) {
                retired.insert(pair);
            }
        } else {
            answers.ask(pairs.len(), |rows| {
                let rows = pairs[rows.clone()].iter().zip(&held[rows]);
                gather(rows, |(&pair, &is_held)| is_held && proxies.has_ended(pair))
            });
            let ended = answers.iter();
            ended.for_each(|row| report(PairChange::Deleted(pairs[row])));
        }
        std::mem::swap(pairs, found);
        held.clear();
        self.held_count = 0;
        self.tombstones = 0;
        let pairs = std::mem::take(pairs);
        self.hold_new(&pairs, proxies, report);
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
        if proxies.has_volumes() {
            return self.hold_new_by_volumes(found, proxies, report);
        }
        let Self { held, answers, .. } = self;
        answers.ask(found.len(), |rows| {
            gather(&found[rows], |&pair| proxies.overlap(pair))
        });
        let words = found.chunks(64).zip(answers.words());
        held.extend(
            words.flat_map(|(pairs, word)| (0..pairs.len()).map(move |i| word >> i & 1 == 1)),
        );
        self.held_count += answers.iter().count();
        // Most pairs that are held were held before.
        for i in answers.iter() {
            if !proxies.was_held(found[i]) {
                report(PairChange::Added(found[i]));
            }
        }
    }

    /// What is left of the retired pairs afterwards has ended.
    fn hold_new_by_volumes<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        found: &[[u32; 2]],
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        let Self {
            held,
            retired,
            held_count,
            ..
        } = self;
        for &pair in found {
            let overlaps = proxies.overlap(pair);
            let was_held = overlaps && retired.take(pair);
            let is_held = overlaps && proxies.volumes_meet(pair, was_held);
            held.push(is_held);
            *held_count += usize::from(is_held);
            match (was_held, is_held) {
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
        let Self { pairs, held, .. } = self;
        // Which ones overlap is practically random, so there is no branch on it, only on whether any of many has turned.
        let have_turned = |pairs: &[[u32; 2]], held: &[bool]| {
            if proxies.has_volumes() {
                let overlap = gather(pairs, |&pair| proxies.overlap(pair));
                let held = gather(held, |&is_held| is_held);
                proxies.held_by_volumes(pairs, overlap, held) ^ held
            } else {
                gather(pairs.iter().zip(held), |(&pair, &is_held)| {
                    proxies.overlap(pair) ^ is_held
                })
            }
        };
        if escaped.len() == 0 {
            changed.ask(pairs.len(), |rows| {
                have_turned(&pairs[rows.clone()], &held[rows])
            });
            changed.iter().for_each(|row| self.turn(row, report));
            return false;
        }
        let has_escaped = |&[a, b]: &[u32; 2]| escaped.contains(a) | escaped.contains(b);
        changed.ask(pairs.len(), |rows| {
            let (pairs, held) = (&pairs[rows.clone()], &held[rows]);
            have_turned(pairs, held) | gather(pairs, has_escaped)
        });
        let rows = pairs.len();
        for row in changed.iter() {
            if has_escaped(&self.pairs[row]) {
                self.retire(row, proxies, report);
            } else {
                self.turn(row, report);
            }
        }
        // Backwards, so that the row `swap_remove` moves in has already been checked.
        for row in changed.iter_backwards() {
            if self.pairs[row][0] == TOMBSTONE {
                self.pairs.swap_remove(row);
                self.held.swap_remove(row);
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
            let was_held = self.held[row];
            let is_held = proxies.overlap(pair)
                && (!proxies.has_volumes() || proxies.volumes_meet(pair, was_held));
            if is_held != was_held {
                self.turn(row, report);
            }
        }
    }

    #[inline(always)]
    fn turn(&mut self, row: usize, report: &mut impl FnMut(PairChange)) {
        self.held[row] = !self.held[row];
        if self.held[row] {
            report(PairChange::Added(self.pairs[row]));
            self.held_count += 1;
        } else {
            report(PairChange::Deleted(self.pairs[row]));
            self.held_count -= 1;
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
        if std::mem::take(&mut self.held[row]) {
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
        self.held.retain(|_| {
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
        assert_eq!(self.pairs.len(), self.held.len());
        assert_eq!(self.held().count(), self.held_count);
        assert_eq!(self.iter().count(), self.len());
        for (&pair, &is_held) in self.pairs.iter().zip(&self.held) {
            let should = pair[0] != TOMBSTONE && overlap(now, pair) && volumes_meet(pair, is_held);
            assert_eq!(is_held, should, "{pair:?} is held, or is not");
        }
    }
}

/// The answers for up to 64 items, the first one lowest. Without a branch, because answers are practically random.
#[inline(always)]
fn gather<T>(
    items: impl IntoIterator<Item = T, IntoIter: ExactSizeIterator>,
    ask: impl Fn(T) -> bool,
) -> u64 {
    let items = items.into_iter();
    let unused = 64 - items.len();
    let word = items.fold(0, |word, item| word >> 1 | u64::from(ask(item)) << 63);
    word >> unused
}
