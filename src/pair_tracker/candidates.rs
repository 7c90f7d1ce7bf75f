//! The candidates: pairs of proxies whose fat boxes overlap, with a tombstone in place of each that is gone.
//!
//! When most proxies were touched, all candidates are compared, in order; when few were, their candidates are picked by a bit
//! for each slot; when very few were, by lists. The lists are made once they would have been useful a number of times, and
//! kept up to date until all candidates are replaced.

mod comparing;
mod lists;
mod pair_rules;
mod retired;
mod state;

use crate::aabb::Aabb;
use crate::bit_set::BitSet;
use crate::real::Real;
use crate::tuning::update::SPARSE_FROM_ONE_IN;
pub(super) use comparing::Comparing;
use lists::CandidateLists;
use pair_rules::overlap;
use retired::RetiredPairs;
use state::PairState;

/// In place of a slot: the candidate is gone.
const TOMBSTONE: u32 = u32::MAX;

/// The candidates by rows, the state of each, and the lists through them.
#[derive(Clone, Debug, Default)]
pub(super) struct Candidates {
    /// By slots, smaller first; two tombstones where the candidate is gone.
    pairs: Vec<[u32; 2]>,
    /// By row.
    states: Vec<PairState>,
    pub(super) held_count: usize,
    /// Those whose boxes overlap, held or not.
    pub(super) overlapping_count: usize,
    tombstones: usize,
    pub(super) lists: CandidateLists,
    /// Held pairs that were retired in this update, if there are volumes.
    retired: RetiredPairs,
    /// Scratch: the slots whose candidates are compared.
    slots: BitSet,
    /// Scratch: answers about rows, or about what was found.
    answers: BitSet,
}

impl Candidates {
    /// The candidates that were `found` for boxes that are as large as their fat boxes, of which those in `near` are not held.
    ///
    /// # Errors
    /// If a pair in `near` was not found, or is there twice.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn restored(
        mut found: Vec<[u32; 2]>,
        near: &[[u32; 2]],
    ) -> Result<Self, &'static str> {
        found.sort_unstable();
        let mut states = vec![PairState::Held; found.len()];
        for pair in near {
            let row = found.binary_search(pair).ok();
            match row.map(|row| &mut states[row]) {
                Some(state) if state.is_held() => *state = PairState::Near,
                _ => return Err("snapshot: a pair is near although its boxes do not overlap"),
            }
        }
        Ok(Self {
            held_count: found.len() - near.len(),
            overlapping_count: found.len(),
            pairs: found,
            states,
            ..Self::default()
        })
    }

    /// The pair in a row, if it is not gone.
    #[inline(always)]
    fn get(&self, row: usize) -> Option<[u32; 2]> {
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

    pub(super) fn iter(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let pairs = self.pairs.iter().copied();
        pairs.filter(|pair| pair[0] != TOMBSTONE)
    }

    pub(super) fn held(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.of_state(PairState::Held)
    }

    /// The pairs whose boxes overlap and that are not held.
    pub(super) fn near(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.of_state(PairState::Near)
    }

    fn of_state(&self, wanted: PairState) -> impl Iterator<Item = [u32; 2]> + '_ {
        let all = self.pairs.iter().zip(&self.states);
        all.filter_map(move |(&pair, &state)| (state == wanted).then_some(pair))
    }

    /// Sets the state of a row. Returns the former one.
    #[inline(always)]
    fn set_state(&mut self, row: usize, state: PairState) -> PairState {
        let former = std::mem::replace(&mut self.states[row], state);
        self.overlapping_count += usize::from(state.overlaps());
        self.overlapping_count -= usize::from(former.overlaps());
        self.held_count += usize::from(state.is_held());
        self.held_count -= usize::from(former.is_held());
        former
    }

    /// Removes the tombstones if they are more than a share of all rows.
    pub(super) fn compact_if_sparse(&mut self) {
        if self.tombstones > self.pairs.len() / SPARSE_FROM_ONE_IN {
            self.compact();
        }
    }

    /// Removes the tombstones.
    fn compact(&mut self) {
        if self.tombstones == 0 {
            return;
        }
        let mut pairs = self.pairs.iter();
        self.states
            .retain(|_| pairs.next().is_some_and(|pair| pair[0] != TOMBSTONE));
        self.pairs.retain(|pair| pair[0] != TOMBSTONE);
        self.tombstones = 0;
        // Rows have moved.
        self.lists.forget();
    }

    /// Panics unless states, counts and, if they are made, lists are consistent.
    ///
    /// `volumes_meet` tells whether a pair whose boxes overlap, and that is held or not, should be.
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
        self.lists.validate(&self.pairs);
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
