//! The candidates: pairs of proxies whose fat boxes overlap.
//!
//! When many proxies were touched, all candidates are compared, in order. When few were, their candidates are picked by a flag for each slot.
//! Candidates of slots that nobody has asked about since the last full search are *cold*: they stand behind the others, and are not looked at.

mod comparing;
mod retired;

#[cfg(feature = "serde-serialize")]
use super::changes::pack;
use super::proxies::overlap;
use crate::aabb::Aabb;
use crate::bit_set::{BitSet, gather, ones};
use crate::real::Real;
use crate::slot_set::SlotSet;
pub(super) use comparing::Comparing;
use comparing::RowChange;
use retired::RetiredPairs;

/// Slots. Up to so many that become warm at once are compared with the cold rows one by one. If larger: each takes a pass. If smaller: a flag
/// is looked up for each row.
const FEW_NEW: usize = 8;

/// The state of a candidate. A byte with a bit for each question, so that many candidates are asked at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum PairState {
    /// Its boxes do not overlap.
    Apart = 0b00,
    /// Its boxes overlap. It is not held, because its volumes have not met yet, no longer do, or met only after its keys had forbidden it.
    Near = 0b01,
    /// It is held.
    Held = 0b10,
}

/// The candidates by rows, and the state of each.
#[derive(Clone, Debug, Default)]
pub(super) struct Candidates {
    /// By row, the two slots, smaller first.
    pub(super) pairs: Vec<[u32; 2]>,
    /// By row.
    states: Vec<PairState>,
    pub(super) held_count: usize,
    /// Candidates whose boxes overlap, held or not.
    pub(super) overlapping_count: usize,
    /// The first cold row.
    pub(super) first_cold: usize,
    /// The slots that have no cold rows.
    warm: SlotSet,
    /// In an update, held pairs that were retired and whose boxes overlap.
    retired: RetiredPairs,
    /// In an update, pairs that were retired, whose boxes overlap, and that their keys have come to forbid.
    forbidden: Vec<[u32; 2]>,
    /// The slots of proxies whose box has ever overlapped that of another one that they might meet. Has room only if volumes are in use.
    pub(super) acquainted: BitSet,
    /// In an update, the rows that cannot be answered before volumes are read.
    unread: Vec<usize>,
    /// Scratch: the changes of rows, by parts of the rows.
    row_changes: Vec<Vec<RowChange>>,
    /// In an update, the rows whose candidates are retired, ascending.
    gone: Vec<usize>,
}

impl Candidates {
    /// Makes room for this number of slots.
    pub(super) fn make_room(&mut self, slots: usize, volumes: bool) {
        self.warm.make_room(slots);
        if volumes {
            self.acquainted.resize(slots);
        }
    }

    /// Makes candidates of the pairs that were `found`, whose boxes all overlap. Those in `near`, in ascending order, are not held. There must
    /// be room for the acquainted slots. Fails if a pair was found twice, or if one in `near` was not found or is out of order.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn restore(
        &mut self,
        mut found: Vec<[u32; 2]>,
        near: &[[u32; 2]],
        acquainted: &[u32],
    ) -> Result<(), &'static str> {
        found.sort_unstable_by_key(|&pair| pack(pair));
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
            self.acquainted.insert(slot as usize);
        }
        Ok(())
    }

    pub(super) fn len(&self) -> usize {
        self.pairs.len()
    }

    pub(super) fn of_state(&self, wanted: PairState) -> impl Iterator<Item = [u32; 2]> + '_ {
        let all = self.pairs.iter().zip(&self.states);
        all.filter_map(move |(&pair, &state)| (state == wanted).then_some(pair))
    }

    /// Calls `visit` with each pair whose boxes overlap, that is not held, and that has one of these slots. The rows of these slots become warm.
    pub(super) fn visit_near(&mut self, listed: &[u32], mut visit: impl FnMut([u32; 2])) {
        if listed.is_empty() || self.overlapping_count == self.held_count {
            return;
        }
        self.warm_up(listed);
        let asked = SlotSet::of(listed);
        let warm = self.pairs[..self.first_cold].iter().zip(&self.states);
        let near = warm.filter(|&(&pair, &state)| state == PairState::Near && asked.has_any(pair));
        near.for_each(|(&pair, _)| visit(pair));
    }

    /// Moves the cold rows of these slots before the others. Takes a pass over the cold rows if there is a slot that was not warm.
    fn warm_up(&mut self, listed: &[u32]) {
        let known = self.warm.len();
        self.warm.extend(listed);
        let new = &self.warm.slots()[known..];
        if new.is_empty() {
            return;
        }
        let (first, warm) = (self.first_cold, &self.warm);
        let cold = &self.pairs[first..];
        // Without a branch, so that the compiler compares many slots at once.
        let has = |rows: &[[u32; 2]], new: u32| {
            let slots = rows.as_flattened().iter();
            slots.fold(false, |has, &slot| has | (slot == new))
        };
        let picked = cold
            .chunks(64)
            .enumerate()
            .filter(|(_, rows)| new.len() > FEW_NEW || new.iter().any(|&new| has(rows, new)));
        let asked = picked.flat_map(|(i, rows)| {
            let word = gather(rows, |&pair| warm.has_any(pair));
            ones(word).map(move |bit| first + 64 * i + bit)
        });
        for row in asked.collect::<Vec<_>>() {
            self.swap_with_first_cold(row);
            self.first_cold += 1;
        }
    }

    /// Sets the state of a row.
    #[inline(always)]
    fn set_state(&mut self, row: usize, state: PairState) {
        let former = std::mem::replace(&mut self.states[row], state);
        let [overlapped, overlaps] = [former, state].map(|state| state != PairState::Apart);
        let [was_held, is_held] = [former, state].map(|state| state == PairState::Held);
        if overlaps && !overlapped {
            for slot in self.pairs[row] {
                self.acquainted.insert(slot as usize);
            }
        }
        self.overlapping_count += usize::from(overlaps);
        self.overlapping_count -= usize::from(overlapped);
        self.held_count += usize::from(is_held);
        self.held_count -= usize::from(was_held);
    }

    /// Moves the rows from `first` on before those that are cold, if any slot is warm.
    fn warm_from(&mut self, first: usize) {
        if self.warm.len() > 0 {
            for row in first..self.pairs.len() {
                self.swap_with_first_cold(row);
                self.first_cold += 1;
            }
        }
    }

    #[inline(always)]
    fn swap_with_first_cold(&mut self, row: usize) {
        self.pairs.swap(row, self.first_cold);
        self.states.swap(row, self.first_cold);
    }

    /// Removes the rows that are gone. The other rows may move.
    fn remove_gone(&mut self) {
        // Backwards, so that a row that takes the place of another has been visited already.
        for mut row in std::mem::take(&mut self.gone).into_iter().rev() {
            if row < self.first_cold {
                self.first_cold -= 1;
                self.swap_with_first_cold(row);
                row = self.first_cold;
            }
            self.pairs.swap_remove(row);
            self.states.swap_remove(row);
        }
    }

    /// Panics unless states, counts and cold rows are consistent.
    ///
    /// `should_be_held` says whether a pair whose boxes overlap should be held, given whether it is.
    pub(super) fn validate<R: Real, const D: usize>(
        &self,
        now: &[Aabb<R, D>],
        should_be_held: impl Fn([u32; 2], bool) -> bool,
    ) {
        assert_eq!(self.pairs.len(), self.states.len());
        assert_eq!(self.of_state(PairState::Held).count(), self.held_count);
        let apart = self.of_state(PairState::Apart).count();
        assert_eq!(self.len() - apart, self.overlapping_count);
        let mut cold = self.pairs[self.first_cold..].as_flattened().iter();
        assert!(!cold.any(|&slot| self.warm.contains(slot)));
        for (&pair, &state) in self.pairs.iter().zip(&self.states) {
            let overlaps = overlap(now, pair);
            assert_eq!(state != PairState::Apart, overlaps, "{pair:?} overlaps");
            let is_held = state == PairState::Held;
            let should_be_held = overlaps && should_be_held(pair, is_held);
            assert_eq!(is_held, should_be_held, "{pair:?} is held, or is not");
        }
    }
}

/// Which of up to 64 candidates are near, and which are held. The first candidate is the lowest bit.
#[inline(always)]
pub(super) fn near_and_held(states: &[PairState]) -> [u64; 2] {
    /// The lowest bit of each byte.
    const LOWEST: u64 = 0x0101_0101_0101_0101;
    /// Gathers the lowest bits of all bytes in the highest byte.
    const GATHER: u64 = 0x0102_0408_1020_4080;
    let (mut near, mut held) = (0, 0);
    for (i, eight) in states.chunks(8).enumerate() {
        let word = match eight.first_chunk::<8>() {
            Some(eight) => u64::from_le_bytes(eight.map(|state| state as u8)),
            None => eight
                .iter()
                .rfold(0, |word, &state| word << 8 | u64::from(state as u8)),
        };
        let gathered = |bits: u64| ((bits & LOWEST).wrapping_mul(GATHER) >> 56) << (8 * i);
        near |= gathered(word);
        held |= gathered(word >> 1);
    }
    [near, held]
}
