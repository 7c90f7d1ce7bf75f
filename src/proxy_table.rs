//! The proxies of an engine's colliders: which collider each one stands for, and how its box has changed.
//!
//! The engine knows a collider by a *handle*: the number of its slot, and a generation that tells it from those which
//! had the slot before. The table keeps, by slot, the generation, the box and what the engine wants remembered of the
//! collider. It brings the boxes of listed colliders up to date, and reports how the set of overlapping pairs has
//! changed.
//!
//! Boxes come from one of two sources. [`update`](ProxyTable::update) reads the box of each listed handle, in the order that
//! is best for memory; [`hand_over`](ProxyTable::hand_over) is given them with their handles between two updates. Either way
//! nearly all are moves of known proxies, which [follow](crate::pair_tracker::ProxyChunk::follow) them; the rest is
//! [admitted](ProxyTable::admit).

mod changes;
mod hand_over;
mod reading;
mod slot_run;
#[cfg(feature = "serde-serialize")]
mod snapshot;
mod source;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

use crate::aabb::Aabb;
use crate::diagnostics::Diagnostics;
use crate::overrides::Overrides;
use crate::pair_filter::PairFilter;
use crate::pair_tracker::{
    BoxUpdate, FilterKey, MOST_SLOTS, PairChange, PairObserver, PairTracker,
};
use crate::parallel;
use crate::rank_sweep::RankSweep;
use crate::real::Real;
use crate::settings::Settings;
use crate::stats::Stats;
use crate::stopwatch::{Phase, PhaseTimes, Stopwatch};
use crate::tuning::prices::READ;
use crate::tuning::update::ROOM_AHEAD;
pub(crate) use changes::Changes;
use hand_over::Pending;
use reading::Reader;
#[cfg(feature = "serde-serialize")]
pub(crate) use snapshot::TableSnapshot;
use source::Reading;
pub(crate) use source::{BoxSource, Handle, Lists};

/// The most slots that known colliders may have. So many more may be made for boxes that are handed over.
const MOST_KNOWN_SLOTS: usize = MOST_SLOTS - ROOM_AHEAD;

/// The proxies of all colliders, and the pairs that they form.
#[derive(Clone)]
pub(crate) struct ProxyTable<R: Real, const D: usize, M, K> {
    tracker: PairTracker<R, D, K>,
    /// The generation of the collider in each slot; `None` where there is none.
    generations: Vec<Option<u32>>,
    /// The highest slot that ever had a known collider, plus 1. There may be more slots, for boxes that were handed over.
    known_slots: usize,
    /// What is remembered of the collider in each slot, as many as generations.
    memos: Vec<M>,
    /// How many colliders are known.
    known: usize,
    /// The most slots that known colliders may have.
    most_known_slots: usize,
    /// Slot and generation of each collider beyond them. It is refused, and counts as not known.
    beyond: BTreeMap<u32, u32>,
    /// `proxies`, the known colliders that have a box, is current; the rest is as of the last update.
    stats: Stats,
    /// What the last update gathered.
    last: Gathered,
    has_warned: bool,
    gathered: Gathered,
    pending: Pending<R, D>,
    reader: Reader,
}

/// What was gathered for the update that is not finished.
#[derive(Clone, Copy, Debug, Default)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
struct Gathered {
    is_begun: bool,
    /// As in [`Diagnostics`].
    listed: usize,
    moved: usize,
}

impl<R: Real, const D: usize, M: Clone + Default + Send, K: FilterKey> ProxyTable<R, D, M, K> {
    /// A table without colliders.
    pub(crate) fn new(settings: &Settings<R>) -> Self {
        let volumes = settings.filter == Some(PairFilter::Shapes);
        let mut tracker = PairTracker::new(volumes);
        tracker.stopwatch = Stopwatch::new(settings.timed);
        Self {
            tracker,
            generations: Vec::new(),
            known_slots: 0,
            memos: Vec::new(),
            known: 0,
            most_known_slots: MOST_KNOWN_SLOTS,
            beyond: BTreeMap::new(),
            stats: Stats::default(),
            last: Gathered::default(),
            has_warned: false,
            gathered: Gathered::default(),
            pending: Pending::new(),
            reader: Reader::default(),
        }
    }

    /// What it holds, and what the last update did. **O(1)**.
    pub(crate) fn stats(&self) -> Stats {
        let mut stats = self.stats;
        stats.refused = self.refused();
        self.tracker.describe(&mut stats);
        stats
    }

    /// What tests and studies ask beyond that. **O(1)**.
    pub(crate) fn diagnostics(&self) -> Diagnostics {
        Diagnostics {
            listed: self.last.listed,
            moved: self.last.moved,
            ..self.tracker.diagnostics()
        }
    }

    pub(crate) fn set_overrides(&mut self, overrides: Overrides) {
        self.tracker.set_overrides(overrides);
    }

    fn refused(&self) -> usize {
        // What has no box is refused.
        self.known - self.stats.proxies + self.beyond.len()
    }

    /// The boxes by slot; invalid where there is none.
    pub(crate) fn boxes(&self) -> &[Aabb<R, D>] {
        &self.tracker.proxies.boxes
    }

    /// The fat boxes of all proxies.
    pub(crate) fn fat_boxes(&self) -> impl Iterator<Item = &Aabb<R, D>> {
        let fat_boxes = &self.tracker.proxies.fat_boxes;
        fat_boxes.iter().filter(|fat| fat.is_valid())
    }

    /// The slots whose boxes were written since the last [finish](Self::finish); may repeat.
    fn touched(&self) -> &[u32] {
        self.tracker.proxies.touched()
    }

    /// The held pairs, the collider in the smaller slot first.
    pub(crate) fn pairs<H: Handle>(&self) -> impl Iterator<Item = [H; 2]> + '_ {
        let pairs = self.tracker.pairs();
        pairs.map(|pair| handles(&self.generations, pair))
    }

    /// Calls `visit` with each of these handles whose box has ever overlapped that of another that it might meet, and with each of its
    /// neighbours: what its box overlapped at the end of the last update, and what only their volumes keep it from being a pair with. If
    /// volumes are not in use, the pairs tell all that.
    pub(crate) fn visit_unreported<H: Handle>(
        &mut self,
        listed: &[H],
        mut visit: impl FnMut(H, Option<H>),
    ) {
        if listed.is_empty() || !self.tracker.proxies.volumes().are_used() {
            return;
        }
        let mut slots = Vec::with_capacity(listed.len());
        for &handle in listed {
            if let Some(slot) = self
                .slot_of(handle)
                .filter(|&slot| self.tracker.is_acquainted(slot))
            {
                slots.push(slot);
                visit(handle, None);
            }
        }
        let generations = &self.generations;
        self.tracker.visit_near(&slots, |pair| {
            if generations[pair[1] as usize].is_some() {
                let [first, second] = handles(generations, pair);
                visit(first, Some(second));
            }
        });
    }

    /// The slot of a handle, if it is known to have the handle's collider.
    fn slot_of(&self, handle: impl Handle) -> Option<u32> {
        let (slot, generation) = handle.into_raw_parts();
        is_known(&self.generations, slot, generation).then_some(slot)
    }

    /// Removes a collider, if its slot is known to have it. Its pairs end without an event.
    fn remove(&mut self, handle: impl Handle) {
        let Some(slot) = self.slot_of(handle) else {
            let (slot, generation) = handle.into_raw_parts();
            if self.beyond.get(&slot) == Some(&generation) {
                self.beyond.remove(&slot);
            }
            return;
        };
        let index = slot as usize;
        self.generations[index] = None;
        self.memos[index] = M::default();
        self.known -= 1;
        self.stats.proxies -= usize::from(self.tracker.proxies.get(slot).is_some());
        self.tracker.remove(slot);
    }

    /// An update: removes colliders, then brings the boxes of listed ones up to date with their source. A box that is
    /// renewed is loosened by `margin`. Returns the slots whose boxes it has written; some may repeat.
    pub(crate) fn update<S>(
        &mut self,
        lists: &Lists<'_, S::Handle>,
        source: &S,
        margin: R,
    ) -> &[u32]
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        self.begin();
        let shared = parallel::shared();
        let touched = self.touched().len();
        self.gathered.listed += lists.len();
        self.tracker.stopwatch.enter(Phase::Read);
        // Removals first: a listed collider may already have the slot of a removed one.
        for &handle in lists.removed {
            self.remove(handle);
        }
        if self
            .tracker
            .proxies
            .volumes_mut()
            .note_extents(margin, source.reach())
        {
            self.reset_volumes(source);
        }
        self.admit_pending(lists.removed, source, margin);
        self.read(lists.modified, source, margin);
        self.reinsert(lists.reinserted, source);
        self.read_unmoved(lists.unmoved, source);
        self.read_swept(lists.swept, source);
        self.tracker.stopwatch.leave();
        self.tracker
            .stopwatch
            .times
            .shared
            .add([shared, parallel::shared()]);
        &self.touched()[touched..]
    }

    /// About how much work an update will be, in tenths of a nanosecond.
    pub(crate) fn work_ahead<H>(&self, lists: &Lists<'_, H>) -> u64 {
        let touched = self.touched().len() + lists.modified.len();
        self.reading(lists.len())
            .saturating_add(self.tracker.work_ahead(touched))
    }

    /// About how much work it is to read so many colliders, or to take in their boxes, in tenths of a nanosecond.
    pub(crate) fn reading(&self, colliders: usize) -> u64 {
        let price = self.tracker.proxies.volumes().price(READ);
        price.saturating_mul(colliders as u64)
    }

    /// Whether there is an update to finish, because boxes were handed over.
    pub(crate) fn is_begun(&self) -> bool {
        self.gathered.is_begun
    }

    /// Begins an update, if none has begun, or goes on with it.
    fn begin(&mut self) {
        if !std::mem::replace(&mut self.gathered.is_begun, true) {
            self.tracker.stopwatch.times = PhaseTimes::default();
        }
    }

    /// Makes room for this number of slots, if there is less.
    fn make_room(&mut self, slots: usize) {
        if slots > self.generations.len() {
            self.generations.resize(slots, None);
            self.memos.resize(slots, M::default());
            self.tracker.make_room(slots);
        }
    }

    /// Brings one collider up to date in the general case: it may be new, moved, gone, or in a slot that another one
    /// had.
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
        let Some(Reading { aabb, key, volume }) = read(&mut memo) else {
            // Usually it is listed as removed as well; if not, it is treated as removed all the same.
            return self.remove(handle);
        };
        let Some(slot) = slot.or_else(|| self.add(handle)) else {
            return self.refuse_slot(handle);
        };
        self.memos[slot as usize] = memo;
        let proxies = &mut self.tracker.proxies;
        let renews_box = key.renews_box(proxies.key(slot));
        proxies.set_key(slot, key);
        let update = BoxUpdate::of(&proxies.boxes[slot as usize], &aabb, margin);
        let renewed = match update {
            BoxUpdate::Keep if !renews_box => None,
            BoxUpdate::Renew(renewed) if !renews_box => Some(renewed),
            // A new box gets no margin, as in Rapier: what never moves never needs one.
            _ => Some(aabb),
        };
        proxies.set_volume(slot, &volume, renewed.is_some());
        match renewed {
            None => {}
            Some(renewed) if renewed.is_valid() => {
                self.place(slot, renewed);
                self.gathered.moved += 1;
            }
            Some(_) => self.refuse(handle, aabb),
        }
    }

    /// Adds a collider that is not known, without a box. Returns its slot; `None`, and adds nothing, if there may be no such slot.
    #[inline(always)]
    fn add<H: Handle>(&mut self, handle: H) -> Option<u32> {
        let (slot, generation) = handle.into_raw_parts();
        let index = slot as usize;
        if index >= self.most_known_slots {
            return None;
        }
        // Needed even if the box is invalid: updates are planned by the number of slots.
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

    /// Leaves a collider out, because its box is not valid.
    #[cold]
    fn refuse(&mut self, handle: impl Handle, aabb: Aabb<R, D>) {
        let slot = handle.into_raw_parts().0;
        if self.tracker.proxies.get(slot).is_some() {
            self.tracker.proxies.clear_box(slot);
            self.gathered.moved += 1;
            self.stats.proxies -= 1;
        }
        self.warn(
            handle,
            format_args!("until its box is valid again: {aabb:?}"),
        );
    }

    /// Leaves a collider out, because there may be no such slot.
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

    /// Says of the first collider that is left out why it is, or until when.
    fn warn(&mut self, handle: impl Handle, why: std::fmt::Arguments<'_>) {
        if !std::mem::replace(&mut self.has_warned, true) {
            log::warn!(
                "collider {handle:?} is left out of the broad phase {why}. Further ones are only counted, in Stats::refused."
            );
        }
    }

    /// Ends an update: calls `event` with how the set of pairs has changed, whether each begins, in the order of [`Changes`], which are
    /// scratch. If volumes are in use, held pairs end once they are farther apart than `slack`, and not active.
    pub(crate) fn finish<H: Handle>(
        &mut self,
        slack: R,
        is_active: Option<IsActive<'_, H>>,
        changes: &mut Changes,
        mut event: impl FnMut(bool, [H; 2]),
    ) {
        let mut observer = Observer {
            generations: &self.generations,
            is_active,
            changes,
        };
        let shared = parallel::shared();
        self.tracker.commit(slack, &mut observer);
        self.tracker
            .stopwatch
            .times
            .shared
            .add([shared, parallel::shared()]);
        self.tracker.stopwatch.enter(Phase::Events);
        self.last = std::mem::take(&mut self.gathered);
        let (generations, stats) = (&self.generations, &mut self.stats);
        stats.updates = stats.updates.wrapping_add(1);
        [stats.deleted, stats.added] = changes.drain(|is_added, pair| {
            event(is_added, handles(generations, pair));
        });
        self.tracker.stopwatch.leave();
        self.stats.times = self.tracker.stopwatch.times;
    }

    /// Panics unless the records of colliders are consistent, and the pairs those of a full search.
    pub(crate) fn validate(&self) {
        assert_eq!(self.generations.len(), self.tracker.proxies.len());
        assert_eq!(self.generations.len(), self.memos.len());
        assert!(self.known_slots <= self.most_known_slots);
        let unknown = self.generations.get(self.known_slots..);
        let unknown = unknown.expect("there are at least as many slots as known ones");
        assert!(unknown.iter().all(Option::is_none));
        assert_eq!(self.generations.iter().flatten().count(), self.known);
        assert_eq!(self.count_proxies(), Some(self.stats.proxies));
        // Another kernel than the one in use, so that one checks the other.
        self.tracker.validate(&mut RankSweep::default());
    }

    /// How many known colliders have a box; `None` if a slot has one without a collider that is known or pending.
    fn count_proxies(&self) -> Option<usize> {
        let mut count = 0;
        for (slot, _) in self.tracker.proxies.iter() {
            if self.generations[slot as usize].is_some() {
                count += 1;
            } else {
                self.pending.range((slot, 0)..=(slot, u32::MAX)).next()?;
            }
        }
        Some(count)
    }
}

/// Says whether the contact of two colliders is active; see [`PairObserver::is_active`].
pub(crate) type IsActive<'a, H> = &'a (dyn Fn(H, H) -> bool + Sync);

/// Notes the changes of an update.
struct Observer<'a, H> {
    generations: &'a [Option<u32>],
    is_active: Option<IsActive<'a, H>>,
    changes: &'a mut Changes,
}

impl<H: Handle> PairObserver for Observer<'_, H> {
    fn report(&mut self, change: PairChange) {
        self.changes.note(change);
    }

    fn is_active(&self, pair: [u32; 2]) -> bool {
        self.is_active.is_some_and(|is_active| {
            let [first, second] = handles(self.generations, pair);
            is_active(first, second)
        })
    }
}

/// Whether a slot is known to have the collider of this generation.
#[inline(always)]
fn is_known(generations: &[Option<u32>], slot: u32, generation: u32) -> bool {
    matches!(generations.get(slot as usize), Some(&Some(known)) if known == generation)
}

/// The handles of two slots whose colliders must be known. The slots of a held pair always are.
fn handles<H: Handle>(generations: &[Option<u32>], pair: [u32; 2]) -> [H; 2] {
    pair.map(|slot| {
        let generation = generations[slot as usize];
        let generation = generation.expect("the colliders of a held pair are known");
        H::from_raw_parts(slot, generation)
    })
}
