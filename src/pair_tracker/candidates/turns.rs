//! How candidates change in an update. They are asked in parts, by several threads if there are many, and the answers are applied in order.

use core::ops::Range;

use super::Comparing;
use crate::bit_set::ones;
use crate::pair_tracker::pair_state::PairState;
use crate::pair_tracker::proxies::Rows;
use crate::pair_tracker::{FilterKey, PairObserver, VolumeSource};
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

impl<R: Real, const D: usize, K: FilterKey, O: PairObserver, S: VolumeSource<R, D>>
    Comparing<'_, R, D, K, O, S>
{
    /// Asks the rows of a range that `pick` picks from each 64, and replaces `turns` by their changes.
    pub(super) fn ask(
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
}
