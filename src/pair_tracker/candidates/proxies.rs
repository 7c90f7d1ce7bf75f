//! Which pairs of proxies overlap now, and which did before.

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
    /// How far the volumes of a held pair may be apart before it ends.
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

    /// Whether a pair whose boxes overlap is held, if volumes are in use: one that was held while its volumes are nearer than
    /// the slack, another one as soon as they meet.
    #[inline(always)]
    pub(super) fn volumes_meet(&self, pair: [u32; 2], was_held: bool) -> bool {
        let slack = if was_held { self.slack } else { R::ZERO };
        self.volumes.meet(pair, slack)
    }

    /// Of up to 64 pairs those that are held, if volumes are in use, by which of them overlap and were held.
    #[inline(always)]
    pub(super) fn held_by_volumes(&self, pairs: &[[u32; 2]], overlap: u64, were_held: u64) -> u64 {
        let meet = |i: usize| self.volumes_meet(pairs[i], were_held >> i & 1 == 1);
        ones(overlap).fold(0, |held, i| held | u64::from(meet(i)) << i)
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
