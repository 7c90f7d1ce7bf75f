//! How candidates change in an update. They are asked in parts, by several threads if there are many, and the answers are applied in order.

use core::ops::Range;

use super::Comparing;
use crate::bit_set::ones;
use crate::pair_tracker::pair_state::PairState;
use crate::pair_tracker::proxies::Rows;
use crate::pair_tracker::{FilterKey, PairChange, PairObserver, VolumeSource};
use crate::real::Real;

/// The change of a row.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub(super) row: usize,
    pub(super) next: Next,
}

/// What becomes of a candidate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Next {
    /// It is in this state.
    Is(PairState),
    /// It is asked again once its volumes have been read.
    Unread,
    /// It is retired.
    Gone,
}

/// The answers for a range of the pairs that a search has found.
#[derive(Debug, Default)]
pub(super) struct Found<'a> {
    pub(super) pairs: &'a [[u32; 2]],
    /// One for each pair.
    pub(super) states: &'a mut [PairState],
    pub(super) held_count: usize,
    pub(super) overlapping_count: usize,
    /// The places of pairs whose volumes must be read. Those that were held are, and the others are apart, until then.
    pub(super) unread: Vec<usize>,
    /// Pairs that are near.
    pub(super) near: Vec<[u32; 2]>,
    /// Pairs that were retired in this update, by their places there.
    pub(super) taken: Vec<u32>,
    /// The pairs that begin or end.
    pub(super) changed: Vec<PairChange>,
    /// Pairs of which one proxy has never overlapped another before.
    pub(super) strangers: Vec<[u32; 2]>,
}

impl<R: Real, const D: usize, K: FilterKey, O: PairObserver, S: VolumeSource<R, D>>
    Comparing<'_, R, D, K, O, S>
{
    /// Asks the rows of a range that `pick` picks from each 64, and replaces `turns` by their changes.
    pub(super) fn ask(
        &self,
        all: Range<usize>,
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
                self.ask_picked(start, picked, turns);
            }
        }
    }

    /// Asks the rows from `start` on whose bit is set.
    #[inline(never)]
    fn ask_picked(&self, start: usize, picked: u64, turns: &mut Vec<Turn>) {
        let leavers = &self.proxies.leavers;
        for i in ones(picked) {
            let row = start + i;
            let pair = self.candidates.pairs[row];
            let former = self.candidates.states[row];
            let next = match pair.iter().any(|&slot| leavers.contains(slot)) {
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
    pub(super) fn next(&self, pair: [u32; 2], former: PairState) -> Next {
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

    /// Asks pairs that a search has found.
    pub(super) fn ask_found(&self, found: &mut Found<'_>) {
        let (candidates, proxies) = (&*self.candidates, &*self.proxies);
        let chunks = found.pairs.chunks(64).zip(found.states.chunks_mut(64));
        for (start, (pairs, states)) in (0..).step_by(64).zip(chunks) {
            for i in ones(proxies.overlapping(pairs)) {
                let pair = pairs[i];
                // Most pairs that are held were held before.
                let place = candidates.retired.place(pair);
                let was_held = place.is_some();
                found.taken.extend(place);
                states[i] = match self.next_of_overlapping(pair, was_held) {
                    Next::Is(state) => state,
                    _ => {
                        found.unread.push(start + i);
                        match was_held {
                            true => PairState::Held,
                            false => continue,
                        }
                    }
                };
                let is_held = states[i].is_held();
                found.held_count += usize::from(is_held);
                found.overlapping_count += 1;
                if !is_held {
                    found.near.push(pair);
                }
                if candidates.are_strangers(pair) {
                    found.strangers.push(pair);
                }
                if was_held != is_held {
                    found.changed.push(match was_held {
                        true => PairChange::Deleted(pair),
                        false => PairChange::Added(pair),
                    });
                }
            }
        }
    }
}
