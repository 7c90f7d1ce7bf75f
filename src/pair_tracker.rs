//! The pair set over time: proxies in, changes of the pair set out.
//!
//! A *proxy* is a box kept under a slot number. Between two calls of [`PairTracker::finish`] proxies are
//! placed, moved and removed; `finish` then reports how the set of overlapping pairs has changed.
//!
//! Each proxy has a fat box around its box. The pairs whose fat boxes overlap are the candidates, and only when
//! proxies leave their fat boxes must there be a search for new ones. In between, each candidate is held or not, as its
//! two boxes overlap or not. Neither hashing nor sorting is needed for that. This is the neighbour list of molecular
//! dynamics (Verlet 1967), made exact.

mod candidates;
mod drawing;
mod foresight;
mod horizon;
mod layers;
mod mover;
mod policy;
#[cfg(feature = "serde-serialize")]
mod snapshot;
#[cfg(test)]
mod tests;
mod update;
mod validation;
mod volumes;

use std::fmt::Debug;

use crate::bit_set::BitSet;
use crate::slot_set::SlotSet;
use crate::stopwatch::Stopwatch;
use crate::tuning::update::MOST_NOTES_A_SLOT;
use crate::volume::Volume;
use crate::{Aabb, Kernel, Real, Stats, Work};
use candidates::Candidates;
use foresight::Foresight;
use layers::{Layers, retain_from};
use mover::Mover;
use policy::Spent;
#[cfg(test)]
pub(crate) use volumes::VOLUME_MARGIN;
pub(crate) use volumes::{Volumes, VolumesPart};

#[cfg(feature = "serde-serialize")]
pub(crate) use snapshot::TrackerSnapshot;

/// A change of the pair set, by slots, smaller first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PairChange {
    Added([u32; 2]),
    Deleted([u32; 2]),
}

/// What decides, with the boxes, whether two proxies are a pair. Pairs that may not meet are never candidates.
pub(crate) trait FilterKey: Copy + Debug + Default + PartialEq + Send + Sync {
    /// Whether the two may be a pair; the same in either order.
    fn may_meet(self, other: Self) -> bool;

    /// Whether the two, if they meet, would touch, and not only intersect; the same in either order.
    fn may_touch(self, _other: Self) -> bool {
        true
    }

    /// Whether a proxy whose key has changed from `former` to this one gets a new box, without a margin.
    fn renews_box(self, _former: Self) -> bool {
        false
    }
}

/// What is needed to move proxies in place, by slot.
pub(crate) struct Parts<'a, R, const D: usize, K> {
    pub(crate) boxes: &'a mut [Aabb<R, D>],
    pub(crate) fat_boxes: &'a [Aabb<R, D>],
    pub(crate) keys: &'a [K],
    pub(crate) volumes: VolumesPart<'a, R, D>,
}

/// The proxies and the pairs they form.
#[derive(Clone, Debug)]
pub(crate) struct PairTracker<R, const D: usize, K> {
    /// The box of each slot; all NaN, which overlaps nothing, where there is no proxy.
    boxes: Vec<Aabb<R, D>>,
    /// The boxes as they were at the end of the last `finish`; all NaN too once a proxy is removed.
    previous: Vec<Aabb<R, D>>,
    /// The fat box of each proxy; all NaN where there is none, or none yet.
    fat_boxes: Vec<Aabb<R, D>>,
    /// The filter key of each slot.
    keys: Vec<K>,
    /// The keys at the end of the last `finish`, of slots that have other keys now and had a box then.
    former_keys: Vec<(u32, K)>,
    /// Whether a slot has had another key than the default one, with which all may meet.
    are_filtered: bool,
    /// The volume of each slot, if pairs are told apart by them.
    volumes: Volumes<R, D>,
    /// How far the volumes of held pairs may be apart, as of this `finish`.
    slack: R,
    /// Slots touched since the last `finish`; may repeat.
    touched: Vec<u32>,
    /// Slots whose volume has changed since the last `finish`, but not their box at that time; may repeat.
    stirred: Vec<u32>,
    /// Scratch: the slots that have another box, if volumes are in use.
    renewed: BitSet,
    /// The same for the update before.
    last_touched: Vec<u32>,
    /// Those of `touched` that have left their fat box, have none yet, or are gone.
    escaped: SlotSet,
    foresight: Foresight,
    /// What the last update took.
    pub(crate) work: Work,
    /// What searching has cost since the last full run, that run included.
    spent: Spent,
    full_runs: u64,
    candidates: Candidates,
    layers: Layers<R, D>,
    /// Scratch: the candidates found by the kernel.
    found: Vec<[u32; 2]>,
    pub(crate) stopwatch: Stopwatch,
}

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// A tracker without proxies. `foresight` fixes for how many moves ahead it searches; without `layers`, every search
    /// is for all pairs.
    /// With `volumes`, pairs whose boxes overlap are told apart by their volumes.
    pub(crate) fn new(kernel: Kernel, layers: bool, foresight: Option<u16>, volumes: bool) -> Self {
        Self {
            boxes: Vec::new(),
            previous: Vec::new(),
            fat_boxes: Vec::new(),
            keys: Vec::new(),
            are_filtered: false,
            former_keys: Vec::new(),
            volumes: Volumes::new(volumes),
            slack: R::ZERO,
            touched: Vec::new(),
            stirred: Vec::new(),
            renewed: BitSet::default(),
            last_touched: Vec::new(),
            escaped: SlotSet::default(),
            foresight: Foresight::new(foresight),
            work: Work::default(),
            spent: Spent::default(),
            full_runs: 0,
            candidates: Candidates::default(),
            layers: Layers::new(kernel, layers),
            found: Vec::new(),
            stopwatch: Stopwatch::default(),
        }
    }

    /// The box under this slot, if there is a proxy.
    pub(crate) fn get(&self, slot: u32) -> Option<&Aabb<R, D>> {
        self.boxes.get(slot as usize).filter(|b| b.is_valid())
    }

    /// The box under this slot; all NaN if there is no proxy.
    pub(crate) fn slot_box(&self, slot: u32) -> Aabb<R, D> {
        let aabb = self.boxes.get(slot as usize).copied();
        aabb.unwrap_or(Aabb::ABSENT)
    }

    /// Places or moves the proxy of a slot, for which there must be room. `aabb` must be valid.
    pub(crate) fn place(&mut self, slot: u32, aabb: Aabb<R, D>) {
        self.mover().place(slot, aabb);
    }

    /// Places or moves many proxies.
    pub(crate) fn mover(&mut self) -> Mover<'_, R, D> {
        Mover {
            boxes: &mut self.boxes,
            fat_boxes: &self.fat_boxes,
            touched: &mut self.touched,
            escaped: &mut self.escaped,
            volumes: self.volumes.part(),
            stirred: &mut self.stirred,
        }
    }

    /// Takes note of the margin that boxes have from now on.
    pub(crate) fn note_margin(&mut self, margin: R) {
        if self.volumes.note_margin(margin) {
            self.stirred.extend(0..self.boxes.len() as u32);
        }
    }

    /// Sets the volume of a slot, for which there must be room.
    pub(crate) fn set_volume(&mut self, slot: u32, volume: &Volume<R, D>, is_renewed: bool) {
        if self.volumes.set(slot, volume, is_renewed) && !is_renewed {
            self.stirred.push(slot);
        }
    }

    /// The volumes, if pairs are told apart by them.
    pub(crate) fn volumes(&self) -> &Volumes<R, D> {
        &self.volumes
    }

    /// Sets the filter key of a slot, for which there must be room. If it changes, the proxy is searched for anew.
    pub(crate) fn set_key(&mut self, slot: u32, key: K) {
        let index = slot as usize;
        let former = std::mem::replace(&mut self.keys[index], key);
        if former == key {
            return;
        }
        self.are_filtered = true;
        if self.previous[index].is_valid() {
            // If it changes twice in an update, the first one counts: `finish` keeps it.
            self.former_keys.push((slot, former));
        }
        if self.boxes[index].is_valid() {
            self.touched.push(slot);
            self.escaped.insert(slot);
        }
    }

    /// The filter key of a slot.
    pub(crate) fn key(&self, slot: u32) -> K {
        self.keys.get(slot as usize).copied().unwrap_or_default()
    }

    /// The boxes, the fat boxes and the filter keys of all slots, to move proxies in place. Each move is to be
    /// [noted](Self::note).
    pub(crate) fn parts(&mut self) -> Parts<'_, R, D, K> {
        Parts {
            boxes: &mut self.boxes,
            fat_boxes: &self.fat_boxes,
            keys: &self.keys,
            volumes: self.volumes.part(),
        }
    }

    /// Takes note of proxies that were moved in place, of the ones among `moved` that have left their fat box, and of those
    /// that have another volume.
    pub(crate) fn note(&mut self, moved: &[u32], escaped: &[u32], stirred: &[u32]) {
        self.stirred.extend_from_slice(stirred);
        self.touched.extend_from_slice(moved);
        for &slot in escaped {
            self.escaped.insert(slot);
        }
    }

    /// Forgets what was noted more than once since the last [`finish`](Self::finish), if it takes much memory. **O(1)** a note.
    pub(crate) fn forget_repeats(&mut self) {
        let most = MOST_NOTES_A_SLOT * self.boxes.len();
        for noted in [&mut self.touched, &mut self.stirred] {
            if noted.len() > most {
                noted.sort_unstable();
                noted.dedup();
            }
        }
    }

    /// The number of slots that there is room for.
    pub(crate) fn slots(&self) -> usize {
        self.boxes.len()
    }

    /// Makes room for this number of slots, if there is less.
    #[cold]
    pub(crate) fn make_room(&mut self, slots: usize) {
        if slots > self.boxes.len() {
            for boxes in [&mut self.boxes, &mut self.previous, &mut self.fat_boxes] {
                boxes.resize(slots, Aabb::ABSENT);
            }
            self.keys.resize(slots, K::default());
            self.volumes.make_room(slots);
            self.escaped.make_room(slots);
        }
    }

    /// Takes a proxy away; its pairs end with a [`PairChange::Deleted`] each. Its fat box stays until then, like its
    /// candidates.
    pub(crate) fn refuse(&mut self, slot: u32) {
        let index = slot as usize;
        if index < self.boxes.len() {
            self.boxes[index] = Aabb::ABSENT;
            self.touched.push(slot);
            self.escaped.insert(slot);
        }
    }

    /// Removes a proxy; its pairs end without an event.
    pub(crate) fn remove(&mut self, slot: u32) {
        if let Some(previous) = self.previous.get_mut(slot as usize) {
            *previous = Aabb::ABSENT;
            self.refuse(slot);
        }
    }

    /// The slots whose proxies were placed, refused or removed since the last `finish`; may repeat.
    pub(crate) fn touched(&self) -> &[u32] {
        &self.touched
    }

    /// The boxes by slot; all NaN where there is no proxy.
    pub(crate) fn boxes(&self) -> &[Aabb<R, D>] {
        &self.boxes
    }

    /// The slots that were touched before the last `finish`; may repeat.
    pub(crate) fn last_touched(&self) -> &[u32] {
        &self.last_touched
    }

    /// The held pairs, by slots, smaller first.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.candidates.held()
    }

    /// Calls `visit` with the slots of each pair with one of these slots whose boxes overlapped at the end of the last update, and
    /// that is not held, by its volumes alone. **O(candidates)**.
    pub(crate) fn near(&mut self, slots: &[u32], mut visit: impl FnMut([u32; 2])) {
        if self.volumes.are_used() && !slots.is_empty() {
            let keys = &self.keys;
            self.candidates.near_of(slots, keys.len(), |[a, b]| {
                if keys[a as usize].may_touch(keys[b as usize]) {
                    visit([a, b]);
                }
            });
        }
    }

    /// The slots that have a proxy, with their boxes.
    pub(crate) fn proxies(&self) -> impl Iterator<Item = (u32, &Aabb<R, D>)> {
        (0..).zip(&self.boxes).filter(|(_, b)| b.is_valid())
    }

    /// Fills in what it knows: pairs, candidates, layers, the foresight, full runs.
    pub(crate) fn describe(&self, stats: &mut Stats) {
        stats.pairs = self.candidates.held_count();
        stats.candidates = self.candidates.len();
        stats.above_base = self.layers.slots_above_base();
        stats.foresight = u32::from(self.foresight.moves());
        stats.work = self.work;
        stats.full_runs = self.full_runs;
        stats.classes = self.layers.classes();
        stats.strips = self.layers.strips();
    }
}

/// The overlapping pairs among the valid ones of `boxes` that may meet, by a fresh kernel.
fn overlapping<R: Real, const D: usize, K: FilterKey>(
    kernel: Kernel,
    boxes: &[Aabb<R, D>],
    keys: &[K],
) -> Vec<[u32; 2]> {
    let mut found = Vec::new();
    Layers::new(kernel, true).find_all(boxes, &mut found, &mut Stopwatch::default());
    retain_from(&mut found, 0, |[a, b]| {
        keys[a as usize].may_meet(keys[b as usize])
    });
    found
}
