//! Which pairs of proxies overlap now, and which did before.

use super::array::gather;
use super::state::PairState;
use crate::bit_set::ones;
use crate::pair_tracker::{FilterKey, Volumes};
use crate::{Aabb, Real};

/// What decides which candidates are held: boxes and filter keys, as they are now and as they were at the end of the last
/// update.
pub(in crate::pair_tracker) struct Proxies<'a, R, const D: usize, K> {
    pub(in crate::pair_tracker) now: &'a [Aabb<R, D>],
    pub(in crate::pair_tracker) before: &'a [Aabb<R, D>],
    pub(in crate::pair_tracker) keys: &'a [K],
    /// The former keys of slots whose key has changed, ascending.
    pub(in crate::pair_tracker) former_keys: &'a [(u32, K)],
    /// The volumes of all slots, which decide if they are in use.
    pub(in crate::pair_tracker) volumes: &'a Volumes<R, D>,
    /// How far the volumes of a held pair may be apart.
    pub(in crate::pair_tracker) slack: R,
}

impl<R: Real, const D: usize, K: FilterKey> Proxies<'_, R, D, K> {
    #[inline(always)]
    pub(super) fn overlap(&self, pair: [u32; 2]) -> bool {
        overlap(self.now, pair)
    }

    /// Whether held pairs cannot be told by what there was at the end of the last update.
    #[inline(always)]
    pub(super) fn has_volumes(&self) -> bool {
        self.volumes.are_used()
    }

    /// The state of a pair whose boxes overlap: held, unless volumes are in use. Then a pair is held as soon as its volumes meet,
    /// until one of its boxes is renewed and they are farther apart than the slack.
    #[inline(always)]
    pub(super) fn state_of_overlapping(&self, pair: [u32; 2], was_held: bool) -> PairState {
        let is_held = !self.has_volumes()
            || match was_held {
                false => self.volumes.meet(pair, R::ZERO),
                true => !self.is_renewed(pair) || self.volumes.meet(pair, self.slack),
            };
        match is_held {
            true => PairState::Held,
            false => PairState::Near,
        }
    }

    /// Whether one of two boxes is another one than at the end of the last update.
    #[inline(always)]
    fn is_renewed(&self, pair: [u32; 2]) -> bool {
        pair.iter()
            .any(|&slot| self.now[slot as usize] != self.before[slot as usize])
    }

    /// The state of a pair that had this one.
    #[inline(always)]
    pub(super) fn state_of(&self, pair: [u32; 2], former: PairState) -> PairState {
        match self.overlap(pair) {
            true => self.state_of_overlapping(pair, former.is_held()),
            false => PairState::Apart,
        }
    }

    /// Of up to 64 pairs those whose state is another one now.
    #[inline(always)]
    pub(super) fn turned(&self, pairs: &[[u32; 2]], states: &[PairState]) -> u64 {
        if !self.has_volumes() {
            return gather(pairs.iter().zip(states), |(&pair, &state)| {
                self.overlap(pair) ^ state.is_held()
            });
        }
        let overlap = gather(pairs, |&pair| self.overlap(pair));
        let overlapped = gather(states, |&state| state != PairState::Apart);
        (overlap ^ overlapped) | self.turned_of(overlap, pairs, states)
    }

    /// Of up to 64 pairs those whose boxes overlap, as they did before, and whose volumes have met now.
    #[inline(always)]
    pub(super) fn turned_near(&self, pairs: &[[u32; 2]], states: &[PairState]) -> u64 {
        let near = gather(states, |&state| state == PairState::Near);
        self.turned_of(near, pairs, states)
    }

    /// Of these ones among up to 64 pairs, whose boxes overlap, those whose state is another one now.
    #[inline(always)]
    fn turned_of(&self, these: u64, pairs: &[[u32; 2]], states: &[PairState]) -> u64 {
        let has_turned =
            |i: usize| self.state_of_overlapping(pairs[i], states[i].is_held()) != states[i];
        ones(these).fold(0, |turned, i| turned | u64::from(has_turned(i)) << i)
    }

    /// Whether neither proxy of a pair was removed since the last update.
    #[inline(always)]
    pub(super) fn are_left(&self, pair: [u32; 2]) -> bool {
        pair.iter()
            .all(|&slot| self.before[slot as usize].is_valid())
    }

    /// Whether a pair that may meet now was held before. It was if and only if its boxes overlapped and it might meet then,
    /// because kernels are exact.
    #[inline(always)]
    pub(super) fn was_held(&self, pair: [u32; 2]) -> bool {
        // Keys hardly ever change, so this branch is predicted well; boxes are compared without one.
        let overlapped = overlap(self.before, pair);
        if self.former_keys.is_empty() {
            overlapped
        } else {
            overlapped && self.might_meet(pair)
        }
    }

    /// Whether a held pair whose candidate is retired ends: not if its boxes still overlap and it still may meet, for then
    /// it is found again. The pairs of removed proxies, which have no box before either, end without an event.
    #[inline(always)]
    pub(super) fn has_ended(&self, pair: [u32; 2]) -> bool {
        let overlapped = overlap(self.before, pair);
        if self.former_keys.is_empty() {
            !self.overlap(pair) & overlapped
        } else {
            !(self.overlap(pair) && self.may_meet(pair)) && overlapped
        }
    }

    #[inline]
    fn may_meet(&self, pair: [u32; 2]) -> bool {
        let [a, b] = pair.map(|slot| self.keys[slot as usize]);
        a.may_meet(b)
    }

    #[cold]
    fn might_meet(&self, pair: [u32; 2]) -> bool {
        let [a, b] = pair.map(|slot| {
            let former = self.former_keys.binary_search_by_key(&slot, |key| key.0);
            former.map_or(self.keys[slot as usize], |i| self.former_keys[i].1)
        });
        a.may_meet(b)
    }
}

#[inline(always)]
pub(super) fn overlap<R: Real, const D: usize>(boxes: &[Aabb<R, D>], [a, b]: [u32; 2]) -> bool {
    boxes[a as usize].overlaps(&boxes[b as usize])
}
