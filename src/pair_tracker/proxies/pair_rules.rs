//! The rules that decide which pairs are held, from boxes, filter keys and volumes now and at the end of the last update.

use super::Proxies;
use crate::aabb::Aabb;
use crate::bit_set::{gather, ones};
use crate::pair_tracker::FilterKey;
use crate::pair_tracker::candidates::{PairState, near_and_held};
use crate::real::Real;

impl<R: Real, const D: usize, K: FilterKey> Proxies<R, D, K> {
    /// Whether the boxes of a pair overlap.
    #[inline(always)]
    pub(in crate::pair_tracker) fn overlap(&self, pair: [u32; 2]) -> bool {
        overlap(&self.boxes, pair)
    }

    /// Whether a pair may meet, by the present keys.
    #[inline]
    pub(in crate::pair_tracker) fn may_meet(&self, pair: [u32; 2]) -> bool {
        let [a, b] = pair.map(|slot| self.keys[slot as usize]);
        a.may_meet(b)
    }

    /// Whether both proxies of a pair existed at the end of the last update, and have not been removed since.
    #[inline(always)]
    pub(in crate::pair_tracker) fn both_existed(&self, pair: [u32; 2]) -> bool {
        pair.iter()
            .all(|&slot| self.previous[slot as usize].is_valid())
    }

    /// Whether the keys have come to forbid a candidate whose proxies both existed.
    #[inline(always)]
    pub(in crate::pair_tracker) fn is_forbidden(&self, pair: [u32; 2]) -> bool {
        self.are_rekeyed && self.both_existed(pair) && !self.may_meet(pair)
    }

    /// Whether a pair whose boxes overlap is held; `None` if its volumes decide, and one of them is stale. A pair begins once its keys and its
    /// volumes allow it. Its keys are not asked again, as in Rapier: a pair that they have come to forbid stays. If volumes are in use, it
    /// ends when one of its boxes is renewed and its volumes are farther apart than the slack.
    #[inline(always)]
    pub(in crate::pair_tracker) fn holds(&self, pair: [u32; 2], was_held: bool) -> Option<bool> {
        let volumes = &self.volumes;
        // Until a key changes, all candidates may become pairs.
        if !was_held && self.are_rekeyed && !self.may_meet(pair) {
            return Some(false);
        }
        if !volumes.are_used {
            return Some(true);
        }
        let slack = if was_held { self.slack } else { R::ZERO };
        // Which balls meet is practically random, so there is no branch on it.
        if let Some(meet) = volumes.meet_without_half_axes(pair, slack) {
            return Some(meet | (was_held & !self.renewed.has_any(pair)));
        }
        if was_held && !self.renewed.has_any(pair) {
            return Some(true);
        }
        let are_read = !volumes.are_stale(pair);
        are_read.then(|| volumes.meet(pair, slack))
    }

    /// Of up to 64 pairs those whose boxes overlap.
    #[inline(never)]
    pub(in crate::pair_tracker) fn overlapping(&self, pairs: &[[u32; 2]]) -> u64 {
        // In a function of its own: next to other code, the compiler makes branches of it, which are mispredicted.
        gather(pairs, |&pair| self.overlap(pair))
    }

    /// Of up to 64 candidates those whose state changes, if their keys allow it, and those whose stale volumes decide.
    #[inline(always)]
    pub(in crate::pair_tracker) fn toggled(&self, pairs: &[[u32; 2]], states: &[PairState]) -> u64 {
        let overlap = self.overlapping(pairs);
        let [near, held] = near_and_held(states);
        // Where boxes have begun or ceased to overlap, the state changes in any case.
        let toggled = overlap ^ (near | held);
        if !self.volumes.are_used {
            return toggled;
        }
        toggled | self.changed(overlap & !toggled, held, pairs)
    }

    /// Of up to 64 candidates those that were near, of which a volume is noted, and that begin now or whose stale volumes decide.
    #[inline(always)]
    pub(in crate::pair_tracker) fn changed_of_near(
        &self,
        pairs: &[[u32; 2]],
        states: &[PairState],
    ) -> u64 {
        let [near, held] = near_and_held(states);
        let is_noted = |i: usize| u64::from(self.revolumed.has_any(pairs[i])) << i;
        let noted = ones(near).fold(0, |word, i| word | is_noted(i));
        self.changed(noted, held, pairs)
    }

    /// Of these candidates, whose boxes overlap, those that begin or end, or whose stale volumes decide.
    #[inline(always)]
    fn changed(&self, asked: u64, held: u64, pairs: &[[u32; 2]]) -> u64 {
        ones(asked).fold(0, |word, i| {
            let was_held = held >> i & 1 == 1;
            let has_changed = self.holds(pairs[i], was_held) != Some(was_held);
            word | u64::from(has_changed) << i
        })
    }
}

#[inline(always)]
pub(in crate::pair_tracker) fn overlap<R: Real, const D: usize>(
    boxes: &[Aabb<R, D>],
    [a, b]: [u32; 2],
) -> bool {
    boxes[a as usize].intersects(&boxes[b as usize])
}
