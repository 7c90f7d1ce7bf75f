//! Which pairs of proxies are held, by their boxes, filter keys and volumes as they are now, and as they were at the end of the last
//! update.

use super::state::{PairState, near_and_held};
use super::turns::Rows;
use crate::aabb::Aabb;
use crate::bit_set::{gather, ones};
use crate::pair_tracker::FilterKey;
use crate::pair_tracker::odometer::Due;
use crate::pair_tracker::proxies::Proxies;
use crate::real::Real;

impl<R: Real, const D: usize, K: FilterKey> Proxies<R, D, K> {
    /// Whether the boxes of a pair overlap.
    #[inline(always)]
    pub(in crate::pair_tracker) fn overlap(&self, pair: [u32; 2]) -> bool {
        overlap(&self.boxes, pair)
    }

    /// The state of a pair whose boxes overlap. It begins once its keys and its volumes let it. The keys are not asked again, as in
    /// Rapier: a pair that they have come to forbid stays. If volumes are in use, it ends when one of its boxes is renewed and they are
    /// farther apart than the slack.
    #[inline(always)]
    pub(super) fn state_of_overlapping(&self, pair: [u32; 2], was_held: bool) -> PairState {
        let (volumes, are_used) = (&self.volumes, self.volumes.are_used());
        let is_held = match was_held {
            false => self.may_begin(pair) && (!are_used || volumes.meet(pair, R::ZERO)),
            true => !are_used || !self.is_renewed(pair) || volumes.meet(pair, self.slack),
        };
        match is_held {
            true => PairState::Held,
            false => PairState::Near,
        }
    }

    /// Whether one of two boxes is another one than at the end of the last update.
    #[inline(always)]
    fn is_renewed(&self, pair: [u32; 2]) -> bool {
        let [a, b] = pair.map(|slot| self.renewed.contains(slot as usize));
        a | b
    }

    /// The state of a pair that had this one, and this due, if it has one.
    #[inline(always)]
    pub(super) fn state_of(
        &self,
        pair: [u32; 2],
        former: PairState,
        due: Option<&mut Due>,
    ) -> PairState {
        if !self.overlap(pair) {
            return PairState::Apart;
        }
        let was_held = former.is_held();
        if due.is_some() && !self.has_toggled(pair, was_held, due) {
            return match was_held {
                true => PairState::Held,
                false => PairState::Near,
            };
        }
        self.state_of_overlapping(pair, was_held)
    }

    /// Of up to 64 pairs those whose boxes overlap.
    #[inline(never)]
    pub(super) fn overlapping(&self, pairs: &[[u32; 2]]) -> u64 {
        // By itself: beside other code, the compiler makes branches of it, which are mispredicted.
        gather(pairs, |&pair| self.overlap(pair))
    }

    /// Of up to 64 pairs those whose state is another one now.
    #[inline(always)]
    pub(super) fn toggled(&self, rows: Rows<'_>) -> u64 {
        let Rows {
            pairs,
            states,
            dues,
        } = rows;
        let overlap = self.overlapping(pairs);
        let [near, held] = near_and_held(states);
        // What has begun or ceased to overlap has toggled in any case.
        let toggled = overlap ^ (near | held);
        if !self.volumes.are_used() {
            return toggled;
        }
        let asked = ones(overlap & !toggled).map(|i| (i, pairs[i], held >> i & 1 == 1));
        let bit = |i: usize, has_toggled: bool| u64::from(has_toggled) << i;
        match dues {
            // By itself, as fast as balls are.
            [] => asked.fold(toggled, |word, (i, pair, was_held)| {
                word | bit(i, self.has_toggled(pair, was_held, None))
            }),
            dues => asked.fold(toggled, |word, (i, pair, was_held)| {
                word | bit(i, self.has_toggled(pair, was_held, Some(&mut dues[i])))
            }),
        }
    }

    /// Of up to 64 pairs those that are near, that are `wanted`, and whose volumes have met now.
    #[inline(always)]
    pub(super) fn met_of_near(&self, rows: Rows<'_>, wanted: impl Fn([u32; 2]) -> bool) -> u64 {
        let Rows {
            pairs,
            states,
            dues,
        } = rows;
        let [near, _] = near_and_held(states);
        let mut have_met =
            |i: usize| wanted(pairs[i]) && self.has_toggled(pairs[i], false, dues.get_mut(i));
        ones(near).fold(0, |word, i| word | u64::from(have_met(i)) << i)
    }

    /// Whether a pair whose boxes overlap is held, and was not, or was, and no longer is. Its due is set if it has one.
    #[inline(always)]
    fn has_toggled(&self, pair: [u32; 2], was_held: bool, due: Option<&mut Due>) -> bool {
        // Which balls meet is practically random, so there is no branch on it.
        let slack = if was_held { self.slack } else { R::ZERO };
        if let Some(meet) = self.volumes.meet_as_balls(pair, slack) {
            return (was_held & self.is_renewed(pair) & !meet) | (!was_held & meet);
        }
        if was_held {
            return self.is_renewed(pair) && !self.volumes.meet(pair, slack);
        }
        match due {
            Some(due) => self.volumes.have_met(pair, due),
            None => self.volumes.meet(pair, slack),
        }
    }

    /// Whether neither proxy of a pair was removed since the last update.
    #[inline(always)]
    pub(super) fn are_left(&self, pair: [u32; 2]) -> bool {
        pair.iter()
            .all(|&slot| self.previous[slot as usize].is_valid())
    }

    /// Whether a pair may meet, by the keys as they are now.
    #[inline]
    pub(in crate::pair_tracker) fn may_meet(&self, pair: [u32; 2]) -> bool {
        let [a, b] = pair.map(|slot| self.keys[slot as usize]);
        a.may_meet(b)
    }

    /// Whether a candidate, of proxies of which neither was removed, is one that the keys have come to forbid.
    #[inline(always)]
    pub(super) fn is_forbidden(&self, pair: [u32; 2]) -> bool {
        self.are_rekeyed && self.are_left(pair) && !self.may_meet(pair)
    }

    /// Whether a candidate may become a pair, by the keys as they are now. Until a key changes, all candidates may.
    #[inline(always)]
    fn may_begin(&self, pair: [u32; 2]) -> bool {
        !self.are_rekeyed || self.may_meet(pair)
    }
}

#[inline(always)]
pub(in crate::pair_tracker) fn overlap<R: Real, const D: usize>(
    boxes: &[Aabb<R, D>],
    [a, b]: [u32; 2],
) -> bool {
    boxes[a as usize].intersects(&boxes[b as usize])
}
