//! The array of candidates, with a tombstone in place of each that is gone.

use super::pair_rules::overlap;
use super::retired::RetiredPairs;
use super::state::PairState;
use crate::aabb::Aabb;
use crate::bit_set::BitSet;
use crate::real::Real;
use crate::tuning::update::SPARSE_FROM_ONE_IN;

/// In place of a slot: the candidate is gone.
pub(super) const TOMBSTONE: u32 = u32::MAX;

/// The candidates by rows, and the state of each.
#[derive(Clone, Debug, Default)]
pub(in crate::pair_tracker) struct CandidateArray {
    /// By slots, smaller first; two tombstones where the candidate is gone.
    pub(super) pairs: Vec<[u32; 2]>,
    /// By row.
    pub(super) states: Vec<PairState>,
    pub(in crate::pair_tracker) held_count: usize,
    /// Those whose boxes overlap, held or not.
    pub(in crate::pair_tracker) overlapping_count: usize,
    pub(super) tombstones: usize,
    /// Held pairs that were retired in this update, if there are volumes.
    pub(super) retired: RetiredPairs,
    /// Scratch: answers about rows, or about what was found.
    pub(super) answers: BitSet,
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
    pub(in crate::pair_tracker) fn rows(&self) -> usize {
        self.pairs.len()
    }

    pub(in crate::pair_tracker) fn len(&self) -> usize {
        self.pairs.len() - self.tombstones
    }

    pub(super) fn is_sparse(&self) -> bool {
        self.tombstones > self.pairs.len() / SPARSE_FROM_ONE_IN
    }

    pub(in crate::pair_tracker) fn iter(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let pairs = self.pairs.iter().copied();
        pairs.filter(|pair| pair[0] != TOMBSTONE)
    }

    pub(in crate::pair_tracker) fn held(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.of_state(PairState::Held)
    }

    /// The pairs whose boxes overlap and that are not held.
    pub(in crate::pair_tracker) fn near(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.of_state(PairState::Near)
    }

    fn of_state(&self, wanted: PairState) -> impl Iterator<Item = [u32; 2]> + '_ {
        let all = self.pairs.iter().zip(&self.states);
        all.filter_map(move |(&pair, &state)| (state == wanted).then_some(pair))
    }

    /// Makes `rows` the rows with a picked slot, and possibly some tombstones.
    pub(super) fn pick(&self, rows: &mut BitSet, is_picked: impl Fn(u32) -> bool + Sync + Send) {
        rows.ask(self.pairs.len(), |range| {
            gather(&self.pairs[range], |&[a, b]| is_picked(a) | is_picked(b))
        });
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
