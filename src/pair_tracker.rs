//! The pair set over time: proxies in, changes of the pair set out.
//!
//! A *proxy* is a box and a tag, kept under a slot number. Between two calls of
//! [`PairTracker::finish`] proxies are placed, moved and removed; `finish` then reports how the set of
//! *held* pairs changed. It needs neither hashing nor sorting for that: kernels are exact, so whether a pair
//! was held a moment ago can be read off its two previous boxes, and whether it still is off the present
//! ones.
//!
//! Two proxies are held when their boxes overlap and their tags allow it. A pair that a new tag forbids
//! while the boxes still overlap *lingers*: it stays held until the boxes part. (Rapier's narrow phase drops
//! its contacts by itself, and a deletion of touching colliders would break the broad phase's contract.)

mod layers;
#[cfg(test)]
mod tests;

use std::collections::{BTreeMap, BTreeSet};

use crate::{Aabb, Real};
use layers::{Found, Touched};

pub(crate) use layers::{Layers, Plain};

/// What proxies carry besides their box: it decides which pairs are of interest.
pub(crate) trait Tag: Copy + PartialEq {
    /// Whether this tag allows every pair.
    fn is_open(&self) -> bool;

    /// Whether the pair of two proxies so tagged is to be held. Symmetric.
    fn allows(&self, other: &Self) -> bool;
}

/// A change of the pair set, by slots, smaller first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PairChange {
    Added([u32; 2]),
    Deleted([u32; 2]),
}

/// The proxies and the pairs they form.
#[derive(Clone, Debug)]
pub(crate) struct PairTracker<R, const D: usize, T> {
    /// The box of each slot; all NaN, which overlaps nothing, where there is no proxy.
    boxes: Vec<Aabb<R, D>>,
    /// The boxes as they were at the end of the last `finish`; all NaN too once a proxy is removed.
    previous: Vec<Aabb<R, D>>,
    tags: Vec<T>,
    /// Whether the tag of a slot is open: as much of it as most pairs need.
    is_open: Vec<bool>,
    /// Slots that were placed, retagged or removed since the last `finish`.
    touched: Touched,
    /// The tags at the end of the last `finish` of the slots whose tag has changed since.
    previous_tags: BTreeMap<u32, T>,
    /// The held pairs but for the lingering ones, in the order of the kernel.
    pairs: Vec<[u32; 2]>,
    /// The held pairs whose tags no longer allow them.
    lingering: BTreeSet<[u32; 2]>,
    /// Scratch: the pairs found by the kernel.
    found: Vec<[u32; 2]>,
}

impl<R: Real, const D: usize, T> Default for PairTracker<R, D, T> {
    fn default() -> Self {
        Self {
            boxes: Vec::new(),
            previous: Vec::new(),
            tags: Vec::new(),
            is_open: Vec::new(),
            touched: Touched::default(),
            previous_tags: BTreeMap::new(),
            pairs: Vec::new(),
            lingering: BTreeSet::new(),
            found: Vec::new(),
        }
    }
}

impl<R: Real, const D: usize, T: Tag> PairTracker<R, D, T> {
    /// The box of a slot without a proxy.
    fn absent() -> Aabb<R, D> {
        Aabb::new([R::NAN; D], [R::NAN; D])
    }

    /// The box under this slot, if there is a proxy.
    pub(crate) fn get(&self, slot: u32) -> Option<&Aabb<R, D>> {
        self.boxes.get(slot as usize).filter(|b| b.is_valid())
    }

    /// Places or moves the proxy of a slot. `aabb` must be valid.
    pub(crate) fn place(&mut self, slot: u32, aabb: Aabb<R, D>, tag: T) {
        debug_assert!(aabb.is_valid());
        let index = slot as usize;
        if index >= self.boxes.len() {
            self.boxes.resize(index + 1, Self::absent());
            self.previous.resize(index + 1, Self::absent());
            self.tags.resize(index + 1, tag);
            self.is_open.resize(index + 1, tag.is_open());
        }
        self.retag(slot, tag);
        self.boxes[index] = aabb;
        self.touched.insert(slot);
    }

    /// Gives the proxy of a slot another tag.
    #[inline]
    pub(crate) fn retag(&mut self, slot: u32, tag: T) {
        let index = slot as usize;
        if (self.is_open[index] && tag.is_open()) || self.tags[index] == tag {
            return;
        }
        if self.previous[index].is_valid() {
            self.previous_tags.entry(slot).or_insert(self.tags[index]);
        }
        self.tags[index] = tag;
        self.is_open[index] = tag.is_open();
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

    /// Whether proxies were placed, retagged or removed since the last `finish`.
    pub(crate) fn is_touched(&self) -> bool {
        !self.touched.slots().is_empty()
    }

    /// The held pairs, by slots, smaller first.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.pairs.iter().chain(&self.lingering).copied()
    }

    /// The number of held pairs.
    pub(crate) fn pair_count(&self) -> usize {
        self.pairs.len() + self.lingering.len()
    }

    /// The slots that have a proxy, with their boxes.
    pub(crate) fn proxies(&self) -> impl Iterator<Item = (u32, &Aabb<R, D>)> {
        (0..).zip(&self.boxes).filter(|(_, b)| b.is_valid())
    }

    /// Brings the pairs up to date and reports what has changed since the last call: deletions first, then
    /// additions, each in the order in which the kernel finds the pairs.
    ///
    /// Costs nothing when nothing was touched.
    pub(crate) fn finish(&mut self, layers: &mut Layers<R, D>, mut report: impl FnMut(PairChange)) {
        if !self.is_touched() {
            return;
        }
        let mut found = std::mem::take(&mut self.found);
        found.clear();
        let kind = layers.find(&self.boxes, &self.touched, &mut found);

        let lingering = self.settled_lingering();
        for &pair in &self.lingering {
            self.report_if_parted(pair, &mut report);
        }
        let mut pairs = std::mem::take(&mut self.pairs);
        match kind {
            Found::All => {
                for &pair in &pairs {
                    self.report_if_parted(pair, &mut report);
                }
                pairs.clear();
            }
            Found::OfTouched => pairs.retain(|&pair| {
                let is_touched = self.touched.contains(pair[0]) | self.touched.contains(pair[1]);
                if is_touched {
                    self.report_if_parted(pair, &mut report);
                }
                !is_touched
            }),
        }
        found.retain(|&pair| {
            let allowed = self.allows(pair);
            if allowed && !self.was_held(pair) {
                report(PairChange::Added(pair));
            }
            allowed
        });
        if pairs.is_empty() {
            std::mem::swap(&mut pairs, &mut found);
        } else {
            pairs.extend_from_slice(&found);
        }
        self.pairs = pairs;
        self.found = found;
        self.lingering = lingering;
        self.settle();
    }

    /// Makes the present boxes and tags the previous ones.
    fn settle(&mut self) {
        if self.touched.slots().len() > self.boxes.len() / 4 {
            self.previous.copy_from_slice(&self.boxes);
        } else {
            for &slot in self.touched.slots() {
                self.previous[slot as usize] = self.boxes[slot as usize];
            }
        }
        self.touched.clear();
        self.previous_tags.clear();
    }

    /// Reports the end of a held pair if its boxes have parted. Pairs of removed proxies are passed over.
    #[inline]
    fn report_if_parted(&self, pair: [u32; 2], report: &mut impl FnMut(PairChange)) {
        // The present boxes first: most pairs go on.
        if !Self::overlap(&self.boxes, pair) && Self::overlap(&self.previous, pair) {
            report(PairChange::Deleted(pair));
        }
    }

    /// The pairs that linger after this update: in come those that a new tag has just forbidden, out go those
    /// that have parted or are allowed again.
    fn settled_lingering(&self) -> BTreeSet<[u32; 2]> {
        if self.previous_tags.is_empty() && self.lingering.is_empty() {
            return BTreeSet::new();
        }
        let lingers = |&pair: &[u32; 2]| {
            Self::overlap(&self.previous, pair)
                && Self::overlap(&self.boxes, pair)
                && !self.allows(pair)
        };
        self.pairs().filter(lingers).collect()
    }

    #[inline]
    fn overlap(boxes: &[Aabb<R, D>], [a, b]: [u32; 2]) -> bool {
        boxes[a as usize].overlaps(&boxes[b as usize])
    }

    #[inline]
    fn allows(&self, [a, b]: [u32; 2]) -> bool {
        let [a, b] = [a as usize, b as usize];
        self.is_open[a] || self.is_open[b] || self.tags[a].allows(&self.tags[b])
    }

    /// Whether an overlapping pair was held at the end of the last `finish`.
    #[inline]
    fn was_held(&self, pair: [u32; 2]) -> bool {
        if !Self::overlap(&self.previous, pair) {
            return false;
        }
        if self.previous_tags.is_empty() && self.lingering.is_empty() {
            return true;
        }
        let [a, b] = pair.map(|slot| {
            self.previous_tags
                .get(&slot)
                .unwrap_or(&self.tags[slot as usize])
        });
        a.allows(b) || self.lingering.contains(&pair)
    }

    /// Panics unless the held pairs are exactly what they should be, by a full run of a fresh kernel.
    pub(crate) fn validate(&self, layers: &mut Layers<R, D>) {
        assert_eq!(self.boxes.len(), self.previous.len());
        assert_eq!(self.boxes.len(), self.tags.len());
        assert!(
            self.is_open
                .iter()
                .copied()
                .eq(self.tags.iter().map(Tag::is_open))
        );
        assert!(!self.is_touched(), "an update was not finished");
        assert!(self.previous_tags.is_empty(), "an update was not finished");
        let mut expected = Vec::new();
        let kind = layers.find(&self.boxes, &self.touched, &mut expected);
        assert_eq!(kind, Found::All, "the kernel is not fresh");
        expected.retain(|&pair| self.allows(pair));
        let mut held = self.pairs.clone();
        held.sort_unstable();
        expected.sort_unstable();
        assert!(
            held == expected,
            "the held pairs are not the overlapping ones"
        );
        for &pair in &self.lingering {
            assert!(
                Self::overlap(&self.boxes, pair) && !self.allows(pair),
                "{pair:?} lingers without cause"
            );
        }
    }
}
