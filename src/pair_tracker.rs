//! The pair set over time: proxies in, changes of the pair set out.
//!
//! A *proxy* is a box kept under a slot number. Between two calls of [`PairTracker::finish`] proxies are
//! placed, moved and removed; `finish` then reports how the set of overlapping pairs has changed. It needs
//! neither hashing nor sorting for that: kernels are exact, so whether a pair was held a moment ago can be
//! read off its two previous boxes, and whether it still is off the present ones.

mod layers;
mod slot_set;
#[cfg(test)]
mod tests;

use crate::{Aabb, Real};
use layers::Found;
use slot_set::SlotSet;

pub(crate) use layers::{Layers, Unlayered};

/// A change of the pair set, by slots, smaller first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PairChange {
    Added([u32; 2]),
    Deleted([u32; 2]),
}

/// The proxies and the pairs they form.
#[derive(Clone, Debug)]
pub(crate) struct PairTracker<R, const D: usize> {
    /// The box of each slot; all NaN, which overlaps nothing, where there is no proxy.
    boxes: Vec<Aabb<R, D>>,
    /// The boxes as they were at the end of the last `finish`; all NaN too once a proxy is removed.
    previous: Vec<Aabb<R, D>>,
    /// Slots that were placed, lifted or removed since the last `finish`.
    touched: SlotSet,
    /// The held pairs: all those that overlap.
    pairs: Vec<[u32; 2]>,
    /// Scratch: the pairs found by the kernel.
    found: Vec<[u32; 2]>,
}

impl<R, const D: usize> Default for PairTracker<R, D> {
    fn default() -> Self {
        Self {
            boxes: Vec::new(),
            previous: Vec::new(),
            touched: SlotSet::default(),
            pairs: Vec::new(),
            found: Vec::new(),
        }
    }
}

impl<R: Real, const D: usize> PairTracker<R, D> {
    /// The box of a slot without a proxy.
    fn absent() -> Aabb<R, D> {
        Aabb::new([R::NAN; D], [R::NAN; D])
    }

    /// The box under this slot, if there is a proxy.
    pub(crate) fn get(&self, slot: u32) -> Option<&Aabb<R, D>> {
        self.boxes.get(slot as usize).filter(|b| b.is_valid())
    }

    /// Places or moves the proxy of a slot. `aabb` must be valid.
    pub(crate) fn place(&mut self, slot: u32, aabb: Aabb<R, D>) {
        debug_assert!(aabb.is_valid());
        let index = slot as usize;
        if index >= self.boxes.len() {
            self.boxes.resize(index + 1, Self::absent());
            self.previous.resize(index + 1, Self::absent());
        }
        self.boxes[index] = aabb;
        self.touched.insert(slot);
    }

    /// Ends the pairs of a proxy with a [`PairChange::Deleted`] each, and forgets it.
    pub(crate) fn lift(&mut self, slot: u32) {
        if let Some(aabb) = self.boxes.get_mut(slot as usize) {
            *aabb = Self::absent();
            self.touched.insert(slot);
        }
    }

    /// Forgets a proxy and its pairs without a word.
    pub(crate) fn remove(&mut self, slot: u32) {
        if let Some(previous) = self.previous.get_mut(slot as usize) {
            *previous = Self::absent();
            self.lift(slot);
        }
    }

    /// Whether proxies were placed, lifted or removed since the last `finish`.
    pub(crate) fn is_touched(&self) -> bool {
        !self.touched.slots().is_empty()
    }

    /// The held pairs, by slots, smaller first.
    pub(crate) fn pairs(&self) -> &[[u32; 2]] {
        &self.pairs
    }

    /// The slots that have a proxy, with their boxes.
    pub(crate) fn proxies(&self) -> impl Iterator<Item = (u32, &Aabb<R, D>)> {
        (0..).zip(&self.boxes).filter(|(_, b)| b.is_valid())
    }

    /// Brings the pairs up to date and reports what has changed since the last call: deletions first, then
    /// additions.
    ///
    /// Costs nothing when nothing was touched; **O(touched · log n + pairs)** when little was, and a run of
    /// the kernel over all proxies otherwise.
    pub(crate) fn finish(&mut self, layers: &mut Layers<R, D>, mut report: impl FnMut(PairChange)) {
        if !self.is_touched() {
            return;
        }
        let Self {
            boxes,
            previous,
            touched,
            pairs,
            found,
        } = self;
        found.clear();
        let kind = layers.find(boxes, touched, found);

        // The present boxes first: most pairs go on. The pairs of removed proxies end without a word.
        let mut report_if_parted = |pair| {
            if !overlap(boxes, pair) && overlap(previous, pair) {
                report(PairChange::Deleted(pair));
            }
        };
        match kind {
            Found::All => {
                pairs.drain(..).for_each(report_if_parted);
            }
            Found::OfTouched => pairs.retain(|&[a, b]| {
                let is_touched = touched.contains(a) | touched.contains(b);
                if is_touched {
                    report_if_parted([a, b]);
                }
                !is_touched
            }),
        }
        for &pair in found.iter() {
            if !overlap(previous, pair) {
                report(PairChange::Added(pair));
            }
        }
        if pairs.is_empty() {
            std::mem::swap(pairs, found);
        } else {
            pairs.extend_from_slice(found);
        }
        self.settle();
    }

    /// Makes the present boxes the previous ones.
    fn settle(&mut self) {
        if self.touched.slots().len() > self.boxes.len() / 4 {
            self.previous.copy_from_slice(&self.boxes);
        } else {
            for &slot in self.touched.slots() {
                self.previous[slot as usize] = self.boxes[slot as usize];
            }
        }
        self.touched.clear();
    }

    /// Panics unless the held pairs are exactly those that overlap, by a full run of a fresh kernel, and the
    /// boxes are settled.
    pub(crate) fn validate(&self, layers: &mut Layers<R, D>) {
        assert!(!self.is_touched(), "an update was not finished");
        assert_eq!(self.boxes.len(), self.previous.len());
        for (slot, (now, before)) in self.boxes.iter().zip(&self.previous).enumerate() {
            let is_settled = now == before || !(now.is_valid() || before.is_valid());
            assert!(is_settled, "the box of slot {slot} is not settled");
        }
        let mut expected = Vec::new();
        let kind = layers.find(&self.boxes, &self.touched, &mut expected);
        assert_eq!(kind, Found::All, "the kernel is not fresh");
        let mut held = self.pairs.clone();
        held.sort_unstable();
        expected.sort_unstable();
        assert!(
            held == expected,
            "the held pairs are not the overlapping ones"
        );
    }
}

#[inline]
fn overlap<R: Real, const D: usize>(boxes: &[Aabb<R, D>], [a, b]: [u32; 2]) -> bool {
    boxes[a as usize].overlaps(&boxes[b as usize])
}
