//! What becomes of candidates in an update: asked in parts, by several threads if they are many, and then applied in order.

use core::ops::Range;

use super::Candidates;
use super::state::PairState;
use crate::bit_set::ones;
use crate::pair_tracker::odometer::Due;
use crate::pair_tracker::proxies::Proxies;
use crate::pair_tracker::{FilterKey, PairObserver};
use crate::real::Real;

/// What becomes of a row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub(super) row: usize,
    /// `None`: it is retired.
    pub(super) state: Option<PairState>,
}

/// Of a range of rows, those that turn.
#[derive(Clone, Debug, Default)]
pub(super) struct Turns {
    pub(super) rows: Range<usize>,
    pub(super) turns: Vec<Turn>,
    /// How many rows were picked, tombstones included.
    pub(super) picked: usize,
}

/// Up to 64 rows.
pub(super) struct Rows<'a> {
    pub(super) pairs: &'a [[u32; 2]],
    pub(super) states: &'a [PairState],
    /// As many, or none.
    pub(super) dues: &'a mut [Due],
}

impl Turns {
    /// Asks the rows that are picked from each 64. `dues` are theirs, or none.
    pub(super) fn ask<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        candidates: &Candidates,
        dues: &mut [Due],
        proxies: &Proxies<R, D, K>,
        observer: &impl PairObserver,
        pick: impl Fn(Rows<'_>) -> u64,
    ) {
        self.turns.clear();
        self.picked = 0;
        let mut dues = dues.chunks_mut(64);
        for start in self.rows.clone().step_by(64) {
            let rows = start..self.rows.end.min(start + 64);
            let dues = dues.next().unwrap_or_default();
            let picked = pick(Rows {
                pairs: &candidates.pairs[rows.clone()],
                states: &candidates.states[rows],
                dues: &mut *dues,
            });
            if picked != 0 {
                self.picked += picked.count_ones() as usize;
                self.ask_picked(start, picked, candidates, dues, proxies, observer);
            }
        }
    }

    /// Asks the rows, from `start` on, whose bit is set.
    #[inline(never)]
    fn ask_picked<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        start: usize,
        picked: u64,
        candidates: &Candidates,
        dues: &mut [Due],
        proxies: &Proxies<R, D, K>,
        observer: &impl PairObserver,
    ) {
        let leavers = &proxies.leavers;
        for i in ones(picked) {
            let row = start + i;
            let Some(pair) = candidates.get(row) else {
                continue;
            };
            let former = candidates.states[row];
            let state = match pair.iter().any(|&slot| leavers.contains(slot)) {
                true => None,
                false => Some(next_state(proxies, observer, pair, former, dues.get_mut(i))),
            };
            if state != Some(former) {
                self.turns.push(Turn { row, state });
            }
        }
    }
}

/// The state of a candidate that had this one, and this due, if it has one.
#[inline(always)]
pub(super) fn next_state<R: Real, const D: usize, K: FilterKey>(
    proxies: &Proxies<R, D, K>,
    observer: &impl PairObserver,
    pair: [u32; 2],
    former: PairState,
    due: Option<&mut Due>,
) -> PairState {
    let state = proxies.state_of(pair, former, due);
    settled(observer, pair, former.is_held(), state)
}

/// The state of a pair that is about to have this one: a pair that ends by its volumes alone is held on to while its contact is
/// active.
#[inline(always)]
fn settled(
    observer: &impl PairObserver,
    pair: [u32; 2],
    was_held: bool,
    state: PairState,
) -> PairState {
    match state {
        PairState::Near if was_held && observer.is_active(pair) => PairState::Held,
        _ => state,
    }
}

/// Of a range of what was found, what is held.
#[derive(Debug, Default)]
pub(super) struct Found<'a> {
    pub(super) pairs: &'a [[u32; 2]],
    /// As many.
    pub(super) states: &'a mut [PairState],
    pub(super) notes: FoundNotes,
}

/// What is to be noted of it.
#[derive(Clone, Debug, Default)]
pub(super) struct FoundNotes {
    pub(super) held_count: usize,
    pub(super) overlapping_count: usize,
    /// Those that were retired in this update, by their places there.
    pub(super) taken: Vec<u32>,
    /// Those that begin or end, and which of both.
    pub(super) changed: Vec<([u32; 2], bool)>,
    /// Those of which one has never overlapped another before.
    pub(super) strangers: Vec<[u32; 2]>,
}

impl Found<'_> {
    /// Finds out what is held.
    pub(super) fn ask<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        candidates: &Candidates,
        proxies: &Proxies<R, D, K>,
        observer: &impl PairObserver,
    ) {
        let Self {
            pairs,
            states,
            notes,
        } = self;
        for (pairs, states) in pairs.chunks(64).zip(states.chunks_mut(64)) {
            for i in ones(proxies.overlapping(pairs)) {
                let pair = pairs[i];
                // Most pairs that are held were held before.
                let place = candidates.retired.place(pair);
                let was_held = place.is_some();
                notes.taken.extend(place);
                let state = proxies.state_of_overlapping(pair, was_held);
                let state = settled(observer, pair, was_held, state);
                states[i] = state;
                notes.held_count += usize::from(state.is_held());
                notes.overlapping_count += 1;
                if candidates.are_strangers(pair) {
                    notes.strangers.push(pair);
                }
                if was_held != state.is_held() {
                    notes.changed.push((pair, state.is_held()));
                }
            }
        }
    }
}
