//! The candidates: pairs of proxies whose fat boxes overlap, with a tombstone in place of each that is gone.
//!
//! When most proxies were touched, all candidates are compared, in order. When few were, their candidates are picked by a bit for each
//! slot; when very few were, by lists. The lists are made once they would have been useful a number of times, and kept up to date until
//! all candidates are replaced.

mod comparing;
mod lists;
mod retired;
mod turns;

use super::pair_state::PairState;
use super::proxies::overlap;
use crate::aabb::Aabb;
use crate::bit_set::BitSet;
use crate::real::Real;
pub(super) use comparing::Comparing;
use lists::CandidateLists;
use retired::RetiredPairs;
use turns::{Next, Turn};

/// One row in this many. Once more rows are tombstones, they are removed. If larger: rows are moved, and lists made again, for a few
/// tombstones. If smaller: comparing goes through rows that are gone.
const SPARSE_FROM_ONE_IN: usize = 2;

/// In place of a slot: the candidate is gone.
const TOMBSTONE: u32 = u32::MAX;

/// The candidates by rows, the state of each, and the lists through them.
#[derive(Clone, Debug, Default)]
pub(super) struct Candidates {
    /// By row, the two slots, smaller first; two tombstones where the candidate is gone.
    pairs: Vec<[u32; 2]>,
    /// By row.
    states: Vec<PairState>,
    pub(super) held_count: usize,
    /// Candidates whose boxes overlap, held or not.
    pub(super) overlapping_count: usize,
    tombstones: usize,
    lists: CandidateLists,
    /// How often the candidates of some slots were picked from all rows, and how often they were found by lists; for tests.
    pub(super) passes: [u64; 2],
    /// In an update, held pairs that were retired.
    retired: RetiredPairs,
    /// In an update, pairs that were retired, were not held, and that their keys have come to forbid.
    forbidden: Vec<[u32; 2]>,
    /// The slots of proxies whose box has ever overlapped that of another one that they might meet. Has room only if volumes are in use.
    pub(super) acquainted: BitSet,
    /// Scratch: the slots whose candidates are compared.
    slots: BitSet,
    /// Scratch: answers about rows.
    answers: BitSet,
    /// In an update, the rows that cannot be answered before volumes are read.
    unread: Vec<usize>,
    /// Scratch: the changes of rows, by parts of the rows.
    turns: Vec<Vec<Turn>>,
    /// Whether all tombstones are from these turns.
    are_turned: bool,
}

impl Candidates {
    /// Makes candidates of the pairs that were `found`, whose boxes all overlap. Those in `near`, in ascending order, are not held. There must
    /// be room for the acquainted slots.
    ///
    /// # Errors
    /// A message, if a pair was found twice, or if one in `near` was not found or is out of order.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn restore(
        &mut self,
        mut found: Vec<[u32; 2]>,
        near: &[[u32; 2]],
        acquainted: &[u32],
    ) -> Result<(), &'static str> {
        // Packed pairs compare as single numbers, not slot by slot.
        found.sort_unstable_by_key(|&[a, b]| u64::from(a) << 32 | u64::from(b));
        if !found.is_sorted_by(|a, b| a < b) {
            return Err("snapshot: a pair is there twice");
        }
        let mut states = vec![PairState::Held; found.len()];
        let mut rows = 0..found.len();
        for pair in near {
            let row = rows.find(|&row| found[row] == *pair);
            let row = row.ok_or("snapshot: near pairs are out of order, or do not overlap")?;
            states[row] = PairState::Near;
        }
        self.held_count = found.len() - near.len();
        self.overlapping_count = found.len();
        (self.pairs, self.states) = (found, states);
        for &slot in acquainted.iter().chain(self.pairs.as_flattened()) {
            self.acquainted.insert_if_room(slot as usize);
        }
        Ok(())
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

    #[inline(always)]
    fn note_overlap(&mut self, pair: [u32; 2]) {
        for slot in pair {
            self.acquainted.insert_if_room(slot as usize);
        }
    }

    /// Whether one of a pair is not acquainted yet; false if volumes are not in use.
    #[inline(always)]
    fn are_strangers(&self, pair: [u32; 2]) -> bool {
        pair.iter()
            .any(|&slot| self.acquainted.has_room_without(slot as usize))
    }

    /// Calls `visit` with each pair whose boxes overlap, that is not held, and that has one of these slots; that slot comes first.
    pub(super) fn visit_near(
        &mut self,
        listed: &[u32],
        slots: usize,
        mut visit: impl FnMut([u32; 2]),
    ) {
        if listed.is_empty() || self.overlapping_count == self.held_count {
            return;
        }
        if self.walks_lists(listed.len(), slots) {
            let Self {
                pairs,
                states,
                lists,
                ..
            } = self;
            for &slot in listed {
                lists.walk(slot, |row| {
                    let [a, b] = pairs[row];
                    if states[row] == PairState::Near {
                        visit(if a == slot { [a, b] } else { [b, a] });
                    }
                    a != TOMBSTONE
                });
            }
            return;
        }
        self.slots.insert_all(listed, slots);
        for [a, b] in self.near() {
            for pair in [[a, b], [b, a]] {
                if self.slots.contains(pair[0] as usize) {
                    visit(pair);
                }
            }
        }
        self.slots.clear_around(listed);
    }

    /// Whether the candidates of a number of slots are found by lists, and not picked from all. Makes the lists once they have been missed
    /// often enough.
    fn walks_lists(&mut self, walked: usize, slots: usize) -> bool {
        let pay = CandidateLists::pay(walked, slots, self.rows());
        if pay && !self.lists.are_made && self.lists.are_due() {
            self.compact();
            self.lists.make(&self.pairs, slots);
        }
        let walks_lists = pay && self.lists.are_made;
        self.passes[usize::from(walks_lists)] += 1;
        walks_lists
    }

    /// Sets the state of a row. Returns the former one.
    #[inline(always)]
    fn set_state(&mut self, row: usize, state: PairState) -> PairState {
        let former = std::mem::replace(&mut self.states[row], state);
        if state.overlaps() && !former.overlaps() {
            self.note_overlap(self.pairs[row]);
        }
        self.overlapping_count += usize::from(state.overlaps());
        self.overlapping_count -= usize::from(former.overlaps());
        self.held_count += usize::from(state.is_held());
        self.held_count -= usize::from(former.is_held());
        former
    }

    /// Removes the tombstones if they are too large a share of all rows.
    pub(super) fn compact_if_sparse(&mut self) {
        if self.tombstones > self.pairs.len() / SPARSE_FROM_ONE_IN {
            self.compact();
        }
    }

    /// Fills tombstones with the last rows, if all of them are from the last turns.
    fn fill_tombstones(&mut self) {
        if !std::mem::take(&mut self.are_turned) || self.tombstones == 0 {
            return;
        }
        // Backwards, so that the row that `swap_remove` moves has been visited already.
        for turn in self.turns.iter().flatten().rev() {
            if turn.next == Next::Gone {
                self.pairs.swap_remove(turn.row);
                self.states.swap_remove(turn.row);
            }
        }
        self.tombstones = 0;
        // Rows have moved.
        self.lists.forget();
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
    /// `should_be_held` says whether a pair whose boxes overlap should be held, given whether it is.
    pub(super) fn validate<R: Real, const D: usize>(
        &self,
        now: &[Aabb<R, D>],
        should_be_held: impl Fn([u32; 2], bool) -> bool,
    ) {
        assert_eq!(self.pairs.len(), self.states.len());
        assert_eq!(self.held().count(), self.held_count);
        let overlapping = self.states.iter().filter(|state| state.overlaps());
        assert_eq!(overlapping.count(), self.overlapping_count);
        assert_eq!(self.iter().count(), self.len());
        for (&pair, &state) in self.pairs.iter().zip(&self.states) {
            let overlaps = pair[0] != TOMBSTONE && overlap(now, pair);
            assert_eq!(state != PairState::Apart, overlaps, "{pair:?} overlaps");
            let is_held = overlaps && should_be_held(pair, state.is_held());
            assert_eq!(state.is_held(), is_held, "{pair:?} is held, or is not");
        }
        self.lists.validate(&self.pairs);
    }
}
