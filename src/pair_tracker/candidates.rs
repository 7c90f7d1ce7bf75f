//! The candidates: pairs of proxies whose reaches overlap, and which of them are held.
//!
//! When many proxies have moved, all candidates are gone through in order; when few have, only theirs. For that
//! the candidates of each proxy are linked into a list, in the arrays of the candidates themselves. The lists
//! are made once they would have been of use some times, and kept up until all candidates are replaced.

#[cfg(feature = "serde-serialize")]
mod snapshot;

use super::links::{END, GONE, Links, MOST_LINKED};
use super::{PairChange, SlotSet};
use crate::parallel::{ask_each, ones};
use crate::{Aabb, Real};
#[cfg(feature = "serde-serialize")]
pub(super) use snapshot::CandidatesSnapshot;

/// Going through the list of one slot costs about as much as picking from this many candidates.
const WALK_COST: usize = 32;

/// Making the lists costs about as much as picking so many times.
const LINK_COST: u32 = 8;

/// The boxes that decide which candidates are held: the present ones, and those at the end of the last update.
pub(super) struct Boxes<'a, R, const D: usize> {
    pub(super) now: &'a [Aabb<R, D>],
    pub(super) before: &'a [Aabb<R, D>],
}

impl<R: Real, const D: usize> Boxes<'_, R, D> {
    #[inline(always)]
    fn overlap(&self, pair: [u32; 2]) -> bool {
        overlap(self.now, pair)
    }

    #[inline(always)]
    fn overlapped(&self, pair: [u32; 2]) -> bool {
        overlap(self.before, pair)
    }
}

#[inline(always)]
fn overlap<R: Real, const D: usize>(boxes: &[Aabb<R, D>], [a, b]: [u32; 2]) -> bool {
    boxes[a as usize].overlaps(&boxes[b as usize])
}

/// The candidates.
#[derive(Clone, Debug, Default)]
pub(super) struct Candidates {
    /// By slots, smaller first; [`GONE`] twice where there is none any more.
    pairs: Vec<[u32; 2]>,
    /// Whether the boxes of the pair overlap, too.
    held: Vec<bool>,
    held_count: usize,
    gone_count: usize,
    links: Links,
    /// Scratch: a bit for each slot, and for each candidate.
    picked: Vec<u64>,
    bits: Vec<u64>,
}

impl Candidates {
    /// The held pairs.
    pub(super) fn held(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let all = self.pairs.iter().zip(&self.held);
        all.filter_map(|(&pair, &is_held)| is_held.then_some(pair))
    }

    pub(super) fn held_count(&self) -> usize {
        self.held_count
    }

    /// All candidates, held or not.
    pub(super) fn iter(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.pairs.iter().copied().filter(|pair| pair[0] != GONE)
    }

    pub(super) fn len(&self) -> usize {
        self.pairs.len() - self.gone_count
    }

    /// Makes `found` the candidates, and leaves the memory of the former ones in its place.
    pub(super) fn replace<R: Real, const D: usize>(
        &mut self,
        found: &mut Vec<[u32; 2]>,
        boxes: &Boxes<R, D>,
        report: &mut impl FnMut(PairChange),
    ) {
        let Self {
            pairs, held, bits, ..
        } = self;
        ask_each(pairs.len(), bits, |range| {
            gather(
                pairs[range.clone()].iter().zip(&held[range]),
                |(&pair, &is_held)| is_held && ends(pair, boxes),
            )
        });
        ones(bits).for_each(|i| report(PairChange::Deleted(pairs[i])));
        std::mem::swap(&mut self.pairs, found);
        self.held.clear();
        self.held_count = 0;
        self.gone_count = 0;
        self.links.forget();
        let pairs = std::mem::take(&mut self.pairs);
        self.hold_new(&pairs, boxes, report);
        self.pairs = pairs;
    }

    /// Adds candidates.
    pub(super) fn extend<R: Real, const D: usize>(
        &mut self,
        found: &[[u32; 2]],
        boxes: &Boxes<R, D>,
        report: &mut impl FnMut(PairChange),
    ) {
        let first = self.pairs.len();
        self.hold_new(found, boxes, report);
        self.pairs.extend_from_slice(found);
        if self.pairs.len() > MOST_LINKED {
            self.links.forget();
        }
        if self.links.are_made {
            self.links.add(&self.pairs, first, boxes.now.len());
        }
    }

    fn hold_new<R: Real, const D: usize>(
        &mut self,
        found: &[[u32; 2]],
        boxes: &Boxes<R, D>,
        report: &mut impl FnMut(PairChange),
    ) {
        let Self {
            held,
            held_count,
            bits,
            ..
        } = self;
        ask_each(found.len(), bits, |range| {
            gather(&found[range], |&pair| boxes.overlap(pair))
        });
        let words = found.chunks(64).zip(bits.iter());
        held.extend(
            words.flat_map(|(pairs, word)| (0..pairs.len()).map(move |i| word >> i & 1 == 1)),
        );
        *held_count += ones(bits).count();
        // Few of those that are held were not before.
        for i in ones(bits) {
            if !boxes.overlapped(found[i]) {
                report(PairChange::Added(found[i]));
            }
        }
    }

    /// Brings all candidates up to date with the present boxes, and drops those of the `dropped`, which
    /// have left their reach.
    pub(super) fn refresh_all<R: Real, const D: usize>(
        &mut self,
        dropped: &SlotSet,
        boxes: &Boxes<R, D>,
        report: &mut impl FnMut(PairChange),
    ) {
        self.compact();
        if !dropped.slots().is_empty() {
            let Self { pairs, bits, .. } = self;
            ask_each(pairs.len(), bits, |range| {
                gather(&pairs[range], |&[a, b]| {
                    dropped.contains(a) | dropped.contains(b)
                })
            });
            let bits = std::mem::take(bits);
            ones(&bits).for_each(|i| self.drop_at(i, boxes, report));
            self.bits = bits;
            self.compact();
        }
        let Self {
            pairs,
            held,
            held_count,
            bits,
            ..
        } = self;
        // Which ones overlap is as good as random, so there is no branch on it, only on whether any of many has
        // turned.
        ask_each(pairs.len(), bits, |range| {
            let all = pairs[range.clone()].iter().zip(&held[range]);
            gather(all, |(&pair, &is_held)| boxes.overlap(pair) ^ is_held)
        });
        for i in ones(bits) {
            held[i] = !held[i];
            *held_count = report_turn(pairs[i], held[i], *held_count, report);
        }
    }

    /// Does the same as [`refresh_all`](Self::refresh_all), but looks at the candidates of the `moved` only.
    ///
    /// Picking them out of all candidates is cheap, and going through lists is not: it waits for memory at each
    /// step. So lists are for very few, and they are made once picking has cost as much as making them.
    pub(super) fn refresh_some<R: Real, const D: usize>(
        &mut self,
        dropped: &SlotSet,
        moved: &[u32],
        boxes: &Boxes<R, D>,
        report: &mut impl FnMut(PairChange),
    ) {
        if self.gone_count > self.pairs.len() / 2 {
            self.compact();
        }
        let are_few = WALK_COST * moved.len() < self.pairs.len();
        if are_few && !self.links.are_made && self.pairs.len() <= MOST_LINKED {
            self.links.wanted += 1;
            if self.links.wanted > LINK_COST {
                self.compact();
                self.links.make(&self.pairs, boxes.now.len());
            }
        }
        if are_few && self.links.are_made {
            for &slot in dropped.slots() {
                self.drop_of(slot, boxes, report);
            }
            for &slot in moved {
                self.refresh_of(slot, boxes, report);
            }
        } else {
            self.refresh_picked(dropped, moved, boxes, report);
        }
    }

    fn refresh_picked<R: Real, const D: usize>(
        &mut self,
        dropped: &SlotSet,
        moved: &[u32],
        boxes: &Boxes<R, D>,
        report: &mut impl FnMut(PairChange),
    ) {
        let mut picked = std::mem::take(&mut self.picked);
        picked.resize(boxes.now.len().div_ceil(64), 0);
        for &slot in moved {
            picked[slot as usize / 64] |= 1 << (slot % 64);
        }
        let last = picked.len() - 1;
        // A candidate that is gone has no such slot; any word will do for it.
        let is_picked = |slot: u32| picked[(slot as usize / 64).min(last)] >> (slot % 64) & 1;
        let mut bits = std::mem::take(&mut self.bits);
        let pairs = &self.pairs;
        ask_each(pairs.len(), &mut bits, |range| {
            gather(&pairs[range], |&[a, b]| is_picked(a) | is_picked(b) == 1)
        });
        for i in ones(&bits) {
            let pair = self.pairs[i];
            if pair[0] == GONE {
                continue;
            }
            if dropped.contains(pair[0]) | dropped.contains(pair[1]) {
                self.drop_at(i, boxes, report);
            } else {
                self.refresh_at(i, boxes, report);
            }
        }
        self.bits = bits;
        for &slot in moved {
            picked[slot as usize / 64] = 0;
        }
        self.picked = picked;
    }

    fn drop_at<R: Real, const D: usize>(
        &mut self,
        i: usize,
        boxes: &Boxes<R, D>,
        report: &mut impl FnMut(PairChange),
    ) {
        let pair = std::mem::replace(&mut self.pairs[i], [GONE; 2]);
        self.gone_count += 1;
        if std::mem::take(&mut self.held[i]) {
            self.held_count -= 1;
            if ends(pair, boxes) {
                report(PairChange::Deleted(pair));
            }
        }
    }

    fn refresh_at<R: Real, const D: usize>(
        &mut self,
        i: usize,
        boxes: &Boxes<R, D>,
        report: &mut impl FnMut(PairChange),
    ) {
        let pair = self.pairs[i];
        let overlap = boxes.overlap(pair);
        if overlap != self.held[i] {
            self.held[i] = overlap;
            self.held_count = report_turn(pair, overlap, self.held_count, report);
        }
    }

    /// Whether there are lists.
    #[cfg(test)]
    pub(super) fn are_linked(&self) -> bool {
        self.links.are_made
    }

    /// How many of those that are gone still take room.
    #[cfg(test)]
    pub(super) fn gone(&self) -> usize {
        self.gone_count
    }

    fn drop_of<R: Real, const D: usize>(
        &mut self,
        slot: u32,
        boxes: &Boxes<R, D>,
        report: &mut impl FnMut(PairChange),
    ) {
        let Some(head) = self.links.heads.get_mut(slot as usize) else {
            return;
        };
        let mut link = std::mem::replace(head, END);
        while link != END {
            let (i, side) = (link as usize / 2, link as usize % 2);
            if self.pairs[i][0] != GONE {
                self.drop_at(i, boxes, report);
            }
            link = self.links.next[i][side];
        }
    }

    fn refresh_of<R: Real, const D: usize>(
        &mut self,
        slot: u32,
        boxes: &Boxes<R, D>,
        report: &mut impl FnMut(PairChange),
    ) {
        let Some(&head) = self.links.heads.get(slot as usize) else {
            return;
        };
        let mut link = head;
        let mut last: Option<(usize, usize)> = None;
        while link != END {
            let (i, side) = (link as usize / 2, link as usize % 2);
            let next = self.links.next[i][side];
            if self.pairs[i][0] == GONE {
                // Nobody but the other slot, in its own list, looks at this link any more.
                match last {
                    None => self.links.heads[slot as usize] = next,
                    Some((i, side)) => self.links.next[i][side] = next,
                }
            } else {
                last = Some((i, side));
                self.refresh_at(i, boxes, report);
            }
            link = next;
        }
    }

    /// Forgets the candidates that are gone.
    fn compact(&mut self) {
        if self.gone_count == 0 {
            return;
        }
        let pairs = &self.pairs;
        let mut i = 0;
        self.held.retain(|_| {
            i += 1;
            pairs[i - 1][0] != GONE
        });
        self.pairs.retain(|pair| pair[0] != GONE);
        self.gone_count = 0;
        self.links.forget();
    }

    /// Panics unless the books are in order: flags, counts and, if they are made, links.
    pub(super) fn validate<R: Real, const D: usize>(&self, now: &[Aabb<R, D>]) {
        assert_eq!(self.pairs.len(), self.held.len());
        assert_eq!(self.held().count(), self.held_count);
        assert_eq!(self.iter().count(), self.len());
        for (&pair, &is_held) in self.pairs.iter().zip(&self.held) {
            let overlaps = pair[0] != GONE && overlap(now, pair);
            assert_eq!(is_held, overlaps, "{pair:?} is held, or is not");
        }
        if !self.links.are_made {
            return;
        }
        let mut linked = 0;
        for (slot, &head) in (0..).zip(&self.links.heads) {
            let mut link = head;
            while link != END {
                let (i, side) = (link as usize / 2, link as usize % 2);
                if self.pairs[i][0] != GONE {
                    assert_eq!(self.pairs[i][side], slot, "a link in the wrong list");
                    linked += 1;
                }
                link = self.links.next[i][side];
            }
        }
        assert_eq!(linked, 2 * self.len(), "a candidate is not linked");
    }
}

/// Whether a held pair whose candidate is dropped ends: not if its boxes still overlap, for then it will be found
/// again. The pairs of removed proxies, which have no box before either, do not end but are forgotten without a word.
#[inline(always)]
fn ends<R: Real, const D: usize>(pair: [u32; 2], boxes: &Boxes<R, D>) -> bool {
    !boxes.overlap(pair) & boxes.overlapped(pair)
}

/// The answers for up to 64 items, the first one lowest. Without a branch, for answers are as good as random.
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

/// Reports that a candidate is now held, or no longer, and returns the number of held ones after that.
fn report_turn(
    pair: [u32; 2],
    is_held: bool,
    held_count: usize,
    report: &mut impl FnMut(PairChange),
) -> usize {
    if is_held {
        report(PairChange::Added(pair));
        held_count + 1
    } else {
        report(PairChange::Deleted(pair));
        held_count - 1
    }
}
