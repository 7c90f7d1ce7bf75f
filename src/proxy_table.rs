//! The proxies of an engine's colliders: which collider each one stands for, and how its box changes.
//!
//! The engine names a collider by a *handle*: the index of its slot, and a generation that distinguishes it from earlier colliders in that
//! slot. For each slot, the table keeps the generation, the box, and a memo of the engine's about the collider. It updates the boxes of
//! listed colliders and reports how the set of overlapping pairs changes.
//!
//! Boxes come from two sources. [`update`](ProxyTable::update) reads the box of each listed handle, in the order that suits memory.
//! [`set_boxes`](ProxyTable::set_boxes) receives boxes together with their handles, between two updates. Nearly all of them are moves of known
//! proxies, which [`follow`](crate::pair_tracker::ProxyChunk::follow) handles; [`admit`](ProxyTable::admit) handles the rest.

mod passing;
mod reading;
#[cfg(feature = "serde-serialize")]
mod snapshot;
mod source;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use crate::aabb::Aabb;
use crate::bit_set::BitSet;
use crate::grid_sweep::MAX_BOXES;
use crate::pair_tracker::{Changes, FilterKey, Notes, PairTracker};
use crate::rank_sweep::RankSweep;
use crate::real::Real;
use crate::stats::Stats;
use crate::tuning::update::ROOM_AHEAD;
use passing::Pending;
#[cfg(feature = "serde-serialize")]
pub(crate) use snapshot::TableSnapshot;
use source::Known;
pub(crate) use source::{ColliderSource, Handle, IsActive, Lists, Memo, Reading};

/// The maximum number of slots for known colliders. The rest of [`MAX_BOXES`] is for boxes of unknown colliders.
const MOST_KNOWN_SLOTS: usize = MAX_BOXES - ROOM_AHEAD;

/// The proxies of all colliders, and the pairs that they form.
#[derive(Clone, Default)]
pub(crate) struct ProxyTable<R: Real, const D: usize, M, K> {
    tracker: PairTracker<R, D, K>,
    /// By slot, the generation of the known collider.
    generations: Vec<Option<u32>>,
    /// The highest slot that ever had a known collider, plus 1. Boxes of unknown colliders may have higher slots.
    known_slots: usize,
    /// By slot, the engine's memo about the collider.
    memos: Vec<M>,
    /// The number of known colliders.
    known: usize,
    /// [`MOST_KNOWN_SLOTS`], or less in tests; 0 by default, so only [`new`](Self::new) makes a table.
    most_known_slots: usize,
    /// Slot and generation of each collider beyond these slots. It is refused, and is not a known collider.
    beyond: BTreeMap<u32, u32>,
    /// `proxies` is current; `updates`, `added` and `deleted` are those of the last update. [`stats`](Self::stats) fills in the others.
    stats: Stats,
    has_warned: bool,
    /// Whether an update has begun that [finish](Self::finish) ends.
    is_begun: bool,
    pending: Pending<R, D>,
    /// Scratch: one for each chunk of slots.
    notes: Vec<Notes>,
}

impl<R: Real, const D: usize, M: Memo, K: FilterKey> ProxyTable<R, D, M, K> {
    /// An empty table. `volumes` says whether volumes are in use.
    pub(crate) fn new(volumes: bool) -> Self {
        Self {
            tracker: PairTracker::new(volumes),
            most_known_slots: MOST_KNOWN_SLOTS,
            ..Self::default()
        }
    }

    /// The current counts, and what the last update did. **O(1)**.
    pub(crate) fn stats(&self) -> Stats {
        let mut stats = self.stats;
        stats.refused = self.refused();
        self.tracker.describe(&mut stats);
        stats
    }

    /// The boxes by slot; invalid where there is no proxy.
    pub(crate) fn boxes(&self) -> &[Aabb<R, D>] {
        &self.tracker.proxies.boxes
    }

    /// The fat boxes of all proxies.
    pub(crate) fn fat_boxes(&self) -> impl Iterator<Item = &Aabb<R, D>> {
        let fat_boxes = &self.tracker.proxies.fat_boxes;
        fat_boxes.iter().filter(|fat| fat.is_valid())
    }

    /// The slots whose boxes or keys were written since the last [finish](Self::finish); some may repeat.
    fn touched(&self) -> &[u32] {
        &self.tracker.proxies.notes.touched
    }

    /// The held pairs, the collider in the smaller slot first.
    pub(crate) fn pairs<H: Handle>(&self) -> impl Iterator<Item = [H; 2]> + '_ {
        let pairs = self.tracker.pairs();
        pairs.map(|pair| handles(&self.generations, pair))
    }

    /// Replaces `unreported` by the colliders to wake whose pairs volumes may have suppressed, in the order of slots: each felt collider whose
    /// box has ever overlapped that of another one that it may meet; and both colliders of each pair of a felt or removed one whose boxes
    /// overlapped at the end of the last update, and that is not held because of its volumes, whatever its keys have come to say. There are none
    /// if volumes are not in use.
    pub(crate) fn find_unreported<H: Handle>(
        &mut self,
        felt: &[H],
        removed: &[H],
        unreported: &mut Vec<H>,
    ) {
        unreported.clear();
        if felt.len() + removed.len() == 0 || !self.tracker.proxies.volumes.are_used {
            return;
        }
        let is_acquainted = |slot: &u32| self.tracker.is_acquainted(*slot);
        let acquainted = |&handle: &H| self.slot_of(handle).filter(is_acquainted);
        let mut slots: Vec<_> = felt.iter().filter_map(acquainted).collect();
        let mut woken = BitSet::default();
        woken.resize(self.generations.len());
        slots.iter().for_each(|&slot| woken.insert(slot as usize));
        // Removing a collider wakes its body only if it has a neighbor.
        slots.extend(removed.iter().filter_map(acquainted));
        self.tracker.visit_near(&slots, |pair| {
            pair.iter().for_each(|&slot| woken.insert(slot as usize));
        });
        unreported.extend(woken.iter().filter_map(|slot| {
            let generation = self.generations[slot]?;
            Some(H::from_raw_parts(slot as u32, generation))
        }));
    }

    /// The slot of a known collider.
    fn slot_of(&self, handle: impl Handle) -> Option<u32> {
        let (slot, generation) = handle.into_raw_parts();
        is_known(&self.generations, slot, generation).then_some(slot)
    }

    /// Removes a collider, if it is known. Its pairs end without an event.
    fn remove(&mut self, handle: impl Handle) {
        let (slot, generation) = handle.into_raw_parts();
        if self.beyond.get(&slot) == Some(&generation) {
            self.beyond.remove(&slot);
        }
        if let Some(slot) = self.slot_of(handle) {
            self.generations[slot as usize] = None;
            self.memos[slot as usize] = M::default();
            self.known -= 1;
            self.stats.proxies -= usize::from(self.tracker.proxies.get(slot).is_some());
            self.tracker.remove(slot);
        }
    }

    /// Removes all colliders; counts go on. Their pairs end without an event.
    #[allow(dead_code, reason = "only a patched Rapier 0.36 clears a broad phase")]
    pub(crate) fn clear(&mut self) {
        let mut empty = Self::new(self.tracker.proxies.volumes.are_used);
        empty.tracker.full_searches = self.tracker.full_searches;
        (empty.stats.updates, empty.has_warned) = (self.stats.updates, self.has_warned);
        *self = empty;
    }

    /// Removes colliders, then reads the listed ones. A renewed box is loosened by `margin`. Returns the slots whose boxes or keys it has
    /// written; some may repeat. **O(listed colliders)** and a bit for each slot, or O(n) if all volumes become stale.
    pub(crate) fn update<S: ColliderSource<R, D, Memo = M, Key = K>>(
        &mut self,
        lists: &Lists<'_, S::Handle>,
        source: &S,
        margin: R,
    ) -> &[u32] {
        self.is_begun = true;
        let touched = self.touched().len();
        // Removals first: a listed collider may already have the slot of a removed one.
        lists.removed.iter().for_each(|&handle| self.remove(handle));
        self.tracker.proxies.note_extents(margin, source.reach());
        self.admit_pending(lists.removed, source, margin);
        self.read(lists.modified, source, margin);
        self.reinsert(lists.reinserted, source);
        self.read_in_place(lists.unmoved, source, false);
        self.read_in_place(lists.swept, source, true);
        &self.touched()[touched..]
    }

    /// An estimate of the work of an update, in tenths of a nanosecond.
    pub(crate) fn work_ahead<H>(&self, lists: &Lists<'_, H>) -> u64 {
        let touched = self.touched().len() + lists.modified.len();
        let reading = self.reading_section(lists.len()).work;
        reading.saturating_add(self.tracker.work_ahead(touched))
    }

    /// Whether an update without listed colliders has something to do: boxes have been set, or all volumes must be read again.
    pub(crate) fn is_due(&self, margin: R, reach: R) -> bool {
        let volumes = &self.tracker.proxies.volumes;
        self.is_begun || self.known > 0 && volumes.have_longer_extents(margin, reach)
    }

    /// Makes room for this number of slots, if there is less.
    fn make_room(&mut self, slots: usize) {
        if slots > self.generations.len() {
            self.generations.resize(slots, None);
            self.memos.resize(slots, M::default());
            self.tracker.make_room(slots);
        }
    }

    /// Updates one collider in the general case: it may be new, moved, gone, or in the former slot of another one.
    fn admit<H: Handle>(
        &mut self,
        handle: H,
        margin: R,
        read: impl FnOnce(&mut M) -> Option<Reading<R, D, K>>,
    ) {
        let slot = self.slot_of(handle);
        let mut memo = slot.map_or_else(M::default, |slot| {
            std::mem::take(&mut self.memos[slot as usize])
        });
        let Some(reading) = read(&mut memo) else {
            // The collider is gone or disabled, whether or not it is listed as removed.
            return self.remove(handle);
        };
        let Some(slot) = slot.or_else(|| self.add(handle)) else {
            return self.refuse_slot(handle);
        };
        self.memos[slot as usize] = memo;
        let proxies = &mut self.tracker.proxies;
        let (key, former) = (reading.key, proxies.key(slot));
        proxies.set_key(slot, key);
        let present = proxies.boxes[slot as usize];
        let stays = reading.is_skipped && present.is_valid();
        let aabb = if stays { present } else { reading.aabb };
        let has_only_moved = reading.has_only_moved && key == former;
        let mut all = proxies.all();
        all.follow_volume(slot as usize, &aabb, has_only_moved);
        // A new box gets no margin, as in Rapier: a collider that never moves never needs one.
        if key.renews_box(former) || !all.follow(slot as usize, &aabb, margin) {
            match aabb.is_valid() && (stays || !reading.is_skipped) {
                true => self.place(slot, aabb),
                false => self.refuse(handle, aabb),
            }
        }
    }

    /// Adds an unknown collider without a box. Returns its slot, or `None` if the slot is beyond the maximum.
    #[inline(always)]
    fn add<H: Handle>(&mut self, handle: H) -> Option<u32> {
        let (slot, generation) = handle.into_raw_parts();
        let index = slot as usize;
        if index >= self.most_known_slots {
            return None;
        }
        self.make_room(index + 1);
        if let Some(outdated) = self.generations[index] {
            // Its removal was not reported.
            self.remove(H::from_raw_parts(slot, outdated));
        }
        self.generations[index] = Some(generation);
        self.known_slots = self.known_slots.max(index + 1);
        self.known += 1;
        Some(slot)
    }

    /// Places or moves the proxy of a slot. `aabb` must be valid.
    #[inline(always)]
    fn place(&mut self, slot: u32, aabb: Aabb<R, D>) {
        let is_known = self.generations[slot as usize].is_some();
        let is_new = is_known && self.tracker.proxies.get(slot).is_none();
        self.stats.proxies += usize::from(is_new);
        self.tracker.proxies.place(slot, aabb);
    }

    /// Takes the box of a slot.
    fn clear_box(&mut self, slot: u32) {
        let is_known = self.generations[slot as usize].is_some();
        let counts = is_known && self.tracker.proxies.get(slot).is_some();
        self.stats.proxies -= usize::from(counts);
        self.tracker.proxies.clear_box(slot);
    }

    /// Ends an update: reads volumes, and calls `event` for each change of the pair set, with whether the pair begins, in the order of
    /// [`Changes`]. If volumes are in use, a held pair ends once its volumes are farther apart than `slack` and its contact is not active.
    pub(crate) fn finish<S: ColliderSource<R, D, Memo = M, Key = K>>(
        &mut self,
        source: &S,
        slack: R,
        is_active: Option<IsActive<'_, S::Handle>>,
        changes: &mut Changes,
        mut event: impl FnMut(bool, [S::Handle; 2]),
    ) {
        let known = Known {
            source,
            is_active,
            generations: &self.generations,
            memos: &self.memos,
            extension: self.tracker.proxies.volumes.extension(),
        };
        self.tracker.update(slack, changes, &known);
        self.is_begun = false;
        let (generations, stats) = (&self.generations, &mut self.stats);
        stats.updates = stats.updates.wrapping_add(1);
        [stats.deleted, stats.added] = changes.drain(|is_added, pair| {
            event(is_added, handles(generations, pair));
        });
    }

    /// The number of colliders that are left out: known ones without a box, and those beyond the maximum.
    fn refused(&self) -> usize {
        self.known - self.stats.proxies + self.beyond.len()
    }

    /// Leaves out a collider whose box is invalid, or infinite where such boxes are skipped.
    #[cold]
    fn refuse(&mut self, handle: impl Handle, aabb: Aabb<R, D>) {
        let slot = handle.into_raw_parts().0;
        if self.tracker.proxies.get(slot).is_some() {
            self.clear_box(slot);
        }
        self.warn(
            handle,
            format_args!("until its box is finite and valid: {aabb:?}"),
        );
    }

    /// Leaves out a collider whose slot is beyond the maximum.
    #[cold]
    fn refuse_slot(&mut self, handle: impl Handle) {
        let (slot, generation) = handle.into_raw_parts();
        self.beyond.insert(slot, generation);
        let most = self.most_known_slots;
        self.warn(
            handle,
            format_args!("because its index is not less than {most}"),
        );
    }

    /// Logs why, or until when, the first such collider is left out.
    fn warn(&mut self, handle: impl Handle, why: std::fmt::Arguments<'_>) {
        if !std::mem::replace(&mut self.has_warned, true) {
            log::warn!(
                "collider {handle:?} is left out of the broad phase {why}. Further ones are only counted, in Stats::refused."
            );
        }
    }

    /// Panics unless the table is consistent, and its pairs are those of a full search.
    pub(crate) fn validate(&self) {
        assert_eq!(self.generations.len(), self.tracker.proxies.len());
        assert_eq!(self.generations.len(), self.memos.len());
        assert!(self.known_slots <= self.most_known_slots);
        let mut unknown = self.generations[self.known_slots..].iter();
        assert!(unknown.all(Option::is_none));
        assert_eq!(self.generations.iter().flatten().count(), self.known);
        assert_eq!(self.count_proxies(), Some(self.stats.proxies));
        // Another kernel than the one in use, so that one checks the other.
        self.tracker.validate(&mut RankSweep::default());
    }

    /// The number of known colliders with a box; `None` if a box has neither a known nor a pending collider.
    fn count_proxies(&self) -> Option<usize> {
        let mut count = 0;
        for (slot, _) in (0..).zip(self.boxes()).filter(|(_, aabb)| aabb.is_valid()) {
            match self.generations[slot as usize] {
                Some(_) => count += 1,
                None => _ = self.pending.range((slot, 0)..=(slot, u32::MAX)).next()?,
            }
        }
        Some(count)
    }
}

/// Whether the known collider of a slot has this generation.
#[inline(always)]
fn is_known(generations: &[Option<u32>], slot: u32, generation: u32) -> bool {
    matches!(generations.get(slot as usize), Some(&Some(known)) if known == generation)
}

/// The handles of two slots, whose colliders must be known. Those of a held pair always are.
fn handles<H: Handle>(generations: &[Option<u32>], pair: [u32; 2]) -> [H; 2] {
    pair.map(|slot| {
        let generation = generations[slot as usize];
        let generation = generation.expect("the colliders of a held pair are known");
        H::from_raw_parts(slot, generation)
    })
}
