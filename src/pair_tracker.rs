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
mod foresight;
mod horizon;
mod layers;
mod policy;
#[cfg(feature = "serde-serialize")]
mod snapshot;
#[cfg(test)]
mod tests;

use std::fmt::Debug;

use crate::slot_set::SlotSet;
use crate::stopwatch::{Lap, Stopwatch};
use crate::tuning::update::{COMPARE_ALL_FROM_ONE_IN, KEEP_SCRATCH_UP_TO, SLOTS_A_TASK};
use crate::{Aabb, Kernel, Real, Stats, Work, parallel};
use candidates::{Candidates, Proxies};
use foresight::{Foresight, Spent};
use horizon::mean_speed;
use layers::{Layers, retain_from};
use policy::{Extent, Known, Plan};

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

    /// Whether a proxy whose key was `former` and is this now gets a new box, without a margin.
    fn renews_box(self, _former: Self) -> bool {
        false
    }
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
    /// Slots that were touched since the last `finish`; some may occur more than once.
    moved: Vec<u32>,
    /// Those that were touched before it, since the one before.
    settled: Vec<u32>,
    /// Those of them that have left their fat box, have none yet, or are gone.
    escaped: SlotSet,
    foresight: Foresight,
    /// What the last update took.
    pub(crate) work: Work,
    /// What all have cost since the last full run, that one among them.
    spent: Spent,
    full_runs: u64,
    candidates: Candidates,
    layers: Layers<R, D>,
    /// Scratch: the candidates found by the kernel.
    found: Vec<[u32; 2]>,
    pub(crate) stopwatch: Stopwatch,
}

/// Places and moves proxies in slots for which there is room.
pub(crate) struct Mover<'a, R, const D: usize> {
    boxes: &'a mut [Aabb<R, D>],
    fat_boxes: &'a [Aabb<R, D>],
    moved: &'a mut Vec<u32>,
    escaped: &'a mut SlotSet,
}

impl<R: Real, const D: usize> Mover<'_, R, D> {
    /// The box under a slot; all NaN if there is no proxy.
    #[inline(always)]
    pub(crate) fn held(&self, slot: u32) -> &Aabb<R, D> {
        &self.boxes[slot as usize]
    }

    /// Places or moves the proxy of a slot. `aabb` must be valid.
    #[inline(always)]
    pub(crate) fn place(&mut self, slot: u32, aabb: Aabb<R, D>) {
        debug_assert!(aabb.is_valid());
        let index = slot as usize;
        self.boxes[index] = aabb;
        self.moved.push(slot);
        if !self.fat_boxes[index].contains(&aabb) {
            self.escaped.insert(slot);
        }
    }
}

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// A tracker without proxies. `foresight` fixes for how many moves ahead it searches; without `layers`, every search
    /// is for all pairs.
    pub(crate) fn new(kernel: Kernel, layers: bool, foresight: Option<u16>) -> Self {
        Self {
            boxes: Vec::new(),
            previous: Vec::new(),
            fat_boxes: Vec::new(),
            keys: Vec::new(),
            are_filtered: false,
            former_keys: Vec::new(),
            moved: Vec::new(),
            settled: Vec::new(),
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
        aabb.unwrap_or(absent())
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
            moved: &mut self.moved,
            escaped: &mut self.escaped,
        }
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
            self.moved.push(slot);
            self.escaped.insert(slot);
        }
    }

    /// The filter key of a slot.
    pub(crate) fn key(&self, slot: u32) -> K {
        self.keys.get(slot as usize).copied().unwrap_or_default()
    }

    /// The boxes, the fat boxes and the filter keys of all slots, to move proxies in place. Each move is to be
    /// [noted](Self::note).
    pub(crate) fn parts(&mut self) -> (&mut [Aabb<R, D>], &[Aabb<R, D>], &[K]) {
        (&mut self.boxes, &self.fat_boxes, &self.keys)
    }

    /// Takes note of proxies that were moved, and of those of them that have left their fat box.
    pub(crate) fn note(&mut self, moved: &[u32], escaped: &[u32]) {
        self.moved.extend_from_slice(moved);
        for &slot in escaped {
            self.escaped.insert(slot);
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
                boxes.resize(slots, absent());
            }
            self.keys.resize(slots, K::default());
            self.escaped.make_room(slots);
        }
    }

    /// Takes a proxy away; its pairs end with a [`PairChange::Deleted`] each. Its fat box stays until then, like its
    /// candidates.
    pub(crate) fn refuse(&mut self, slot: u32) {
        let index = slot as usize;
        if index < self.boxes.len() {
            self.boxes[index] = absent();
            self.moved.push(slot);
            self.escaped.insert(slot);
        }
    }

    /// Removes a proxy; its pairs end without an event.
    pub(crate) fn remove(&mut self, slot: u32) {
        if let Some(previous) = self.previous.get_mut(slot as usize) {
            *previous = absent();
            self.refuse(slot);
        }
    }

    /// The slots whose proxies were placed, refused or removed since the last `finish`; some may occur more than once.
    pub(crate) fn touched(&self) -> &[u32] {
        &self.moved
    }

    /// The boxes by slot; all NaN where there is no proxy.
    pub(crate) fn boxes(&self) -> &[Aabb<R, D>] {
        &self.boxes
    }

    /// The slots whose boxes the last update has changed or taken away; some may occur more than once.
    pub(crate) fn settled(&self) -> &[u32] {
        &self.settled
    }

    /// The held pairs, by slots, smaller first.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.candidates.held()
    }

    /// The slots that have a proxy, with their boxes.
    pub(crate) fn proxies(&self) -> impl Iterator<Item = (u32, &Aabb<R, D>)> {
        (0..).zip(&self.boxes).filter(|(_, b)| b.is_valid())
    }

    /// Fills in what it knows: pairs, candidates, layers, the foresight, full runs.
    pub(crate) fn describe(&self, stats: &mut Stats) {
        stats.pairs = self.candidates.held_count();
        stats.candidates = self.candidates.len();
        stats.delta = self.layers.delta();
        stats.foresight = u32::from(self.foresight.moves());
        stats.work = self.work;
        stats.full_runs = self.full_runs;
        stats.classes = self.layers.classes();
        stats.strips = self.layers.strips();
    }

    /// Brings the pairs up to date and reports what has changed since the last call.
    ///
    /// Costs nothing when nothing was touched. Otherwise the candidates of what has moved are compared, or all of
    /// them in order if that is most of them. What has left its fat box is looked up in about **O(log n)** each, and if
    /// that is much, there is a run of the kernel over all proxies.
    pub(crate) fn finish(&mut self, mut report: impl FnMut(PairChange)) {
        let lap = self.stopwatch.start();
        if !self.moved.is_empty() {
            self.candidates.compact_if_sparse();
            // Stable: of several keys that a slot has had in this update, the first one is kept.
            self.former_keys.sort_by_key(|&(slot, _)| slot);
            self.former_keys.dedup_by_key(|&mut (slot, _)| slot);
        }
        let plan = Plan::of::<D>(&self.known(), || {
            mean_speed(&self.moved, &self.boxes, &self.previous)
        });
        let lap = match plan {
            Plan::Nothing => {
                self.settled.clear();
                return;
            }
            Plan::Compare(extent) => {
                self.work = Work::default();
                self.found.clear();
                self.compare(extent, lap, &mut report)
            }
            Plan::LookUp(extent) => {
                let lap = self.look_up(lap);
                self.compare(extent, lap, &mut report)
            }
            Plan::FullRun(foresight) => {
                self.spent = Spent::default();
                self.run_in_full(foresight, lap, &mut report)
            }
        };
        self.spent.add(policy::price(&self.work, self.moved.len()));
        self.settle();
        self.stopwatch.lap(lap, |times| &mut times.difference);
    }

    /// What decides the plan.
    fn known(&self) -> Known {
        Known {
            slots: self.boxes.len(),
            moved: self.moved.len(),
            escaped: self.escaped.len(),
            candidates: self.candidates.len(),
            held: self.candidates.held_count(),
            rows: self.candidates.rows(),
            lists: self.candidates.lists(),
            are_layers_used: self.layers.are_used(),
            base: self.layers.base(),
            foresight: self.foresight,
            spent: self.spent,
        }
    }

    /// Draws the fat boxes of the escaped anew and looks them up among all others.
    fn look_up(&mut self, lap: Lap) -> Lap {
        let horizon = self.foresight.horizon();
        for &slot in self.escaped.slots() {
            let i = slot as usize;
            self.fat_boxes[i] = horizon.fat_box(&self.boxes[i], &self.previous[i]);
        }
        self.stopwatch.lap(lap, |times| &mut times.difference);
        self.found.clear();
        let Self {
            layers,
            fat_boxes,
            escaped,
            found,
            work,
            stopwatch,
            ..
        } = self;
        *work = layers.find_escaped(fat_boxes, escaped, found, stopwatch);
        self.keep_those_that_may_meet()
    }

    /// Compares candidates, retires those of the escaped, and takes in those that were found for them.
    fn compare(&mut self, extent: Extent, lap: Lap, report: &mut impl FnMut(PairChange)) -> Lap {
        let proxies = Proxies {
            now: &self.boxes,
            before: &self.previous,
            keys: &self.keys,
            former_keys: &self.former_keys,
        };
        let (moved, escaped) = (&self.moved, &self.escaped);
        let comparing = self
            .candidates
            .compare(extent, moved, escaped, &proxies, report);
        self.work = Work {
            compared: comparing.compared,
            picked: comparing.picked,
            walked: comparing.walked,
            ..self.work
        };
        self.candidates.extend(&self.found, &proxies, report);
        if !self.foresight.is_fixed() && self.are_too_many(self.candidates.len()) {
            self.foresight.shorten();
            self.layers.forget();
        }
        lap
    }

    /// Searches for all candidates, by fat boxes that are drawn with this foresight.
    fn run_in_full(
        &mut self,
        foresight: Foresight,
        lap: Lap,
        report: &mut impl FnMut(PairChange),
    ) -> Lap {
        self.full_runs += 1;
        self.foresight = foresight;
        self.work = Work::default();
        self.draw_moved();
        self.found.clear();
        let count = self.candidates.len();
        self.found.reserve_exact(count + count / 8);
        let mut lap = self.search(lap);
        while !self.foresight.is_fixed() && self.are_too_many_found() {
            self.foresight.shorten();
            self.draw_all();
            self.found = Vec::new();
            lap = self.search(lap);
            // Also if there was no foresight before: what has not moved since may have its fat box from an earlier time.
            if !self.foresight.is_any() {
                break;
            }
        }
        let proxies = Proxies {
            now: &self.boxes,
            before: &self.previous,
            keys: &self.keys,
            former_keys: &self.former_keys,
        };
        self.candidates.replace(&mut self.found, &proxies, report);
        if self.found.capacity() > KEEP_SCRATCH_UP_TO {
            self.found = Vec::new();
        }
        lap
    }

    /// Appends the overlapping pairs among all fat boxes to what was found.
    fn search(&mut self, lap: Lap) -> Lap {
        self.stopwatch.lap(lap, |times| &mut times.difference);
        self.layers
            .find_all(&self.fat_boxes, &mut self.found, &mut self.stopwatch);
        self.work.searched += self.boxes.len();
        self.work.found += self.found.len();
        self.keep_those_that_may_meet()
    }

    /// Drops the pairs found that may not meet.
    fn keep_those_that_may_meet(&mut self) -> Lap {
        let lap = self.stopwatch.start();
        if self.are_filtered {
            let keys = &self.keys;
            retain_from(&mut self.found, 0, |[a, b]| {
                keys[a as usize].may_meet(keys[b as usize])
            });
        }
        lap
    }

    fn are_too_many(&self, candidates: usize) -> bool {
        policy::are_too_many(candidates, self.boxes.len(), self.candidates.held_count())
    }

    /// The same of those that were found, of which it is not known yet how many are held.
    fn are_too_many_found(&self) -> bool {
        let overlap =
            |&&[a, b]: &&[u32; 2]| self.boxes[a as usize].overlaps(&self.boxes[b as usize]);
        // They are hardly ever that many, so hardly ever compared here.
        self.are_too_many(self.found.len()) && {
            let held = self.found.iter().filter(overlap).count();
            policy::are_too_many(self.found.len(), self.boxes.len(), held)
        }
    }

    /// Draws the fat boxes of what has moved.
    fn draw_moved(&mut self) {
        let Self {
            boxes,
            previous,
            fat_boxes,
            foresight,
            ..
        } = self;
        let horizon = foresight.horizon();
        if self.moved.len() < boxes.len() / COMPARE_ALL_FROM_ONE_IN {
            for &slot in &self.moved {
                let i = slot as usize;
                fat_boxes[i] = horizon.fat_box(&boxes[i], &previous[i]);
            }
            return;
        }
        let draw = |fat_boxes: &mut [Aabb<R, D>], boxes: &[_], previous: &[_]| {
            for (fat, (now, before)) in fat_boxes.iter_mut().zip(boxes.iter().zip(previous)) {
                // The others have not moved, or came back at once.
                if now != before || !fat.contains(now) {
                    *fat = horizon.fat_box(now, before);
                }
            }
        };
        if boxes.len() <= SLOTS_A_TASK {
            return draw(fat_boxes, boxes, previous);
        }
        let boxes = boxes
            .chunks(SLOTS_A_TASK)
            .zip(previous.chunks(SLOTS_A_TASK));
        let mut parts: Vec<_> = fat_boxes.chunks_mut(SLOTS_A_TASK).zip(boxes).collect();
        parallel::for_each(&mut parts, |(fat_boxes, (boxes, previous))| {
            draw(fat_boxes, boxes, previous);
        });
    }

    /// Draws all fat boxes.
    fn draw_all(&mut self) {
        let horizon = self.foresight.horizon();
        let boxes = self.boxes.iter().zip(&self.previous);
        for (fat, (now, before)) in self.fat_boxes.iter_mut().zip(boxes) {
            *fat = horizon.fat_box(now, before);
        }
    }

    /// Makes the present boxes the previous ones.
    fn settle(&mut self) {
        if self.moved.len() <= self.boxes.len() / COMPARE_ALL_FROM_ONE_IN {
            for &slot in &self.moved {
                self.previous[slot as usize] = self.boxes[slot as usize];
            }
        } else if self.boxes.len() <= SLOTS_A_TASK {
            self.previous.copy_from_slice(&self.boxes);
        } else {
            let boxes = self.boxes.chunks(SLOTS_A_TASK);
            let mut parts: Vec<_> = self.previous.chunks_mut(SLOTS_A_TASK).zip(boxes).collect();
            parallel::for_each(&mut parts, |(previous, boxes)| {
                previous.copy_from_slice(boxes)
            });
        }
        std::mem::swap(&mut self.moved, &mut self.settled);
        self.moved.clear();
        self.escaped.clear();
        self.former_keys.clear();
    }

    /// Panics unless the pairs held since the last `finish` are exactly those that overlapped then, by a full run of a
    /// kernel, and everything else that is kept is consistent.
    pub(crate) fn validate(&self, kernel: Kernel) {
        let Self {
            boxes,
            previous,
            fat_boxes,
            keys,
            ..
        } = self;
        assert_eq!(boxes.len(), previous.len());
        assert_eq!(boxes.len(), fat_boxes.len());
        assert_eq!(boxes.len(), keys.len());
        assert!(self.former_keys.is_empty());
        for (slot, (before, fat)) in previous.iter().zip(fat_boxes).enumerate() {
            let is_sound = fat.contains(before) || !(before.is_valid() || fat.is_valid());
            assert!(is_sound, "the box of slot {slot} is not in its fat box");
        }
        let mut moved = SlotSet::default();
        moved.make_room(boxes.len());
        self.moved.iter().for_each(|&slot| moved.insert(slot));
        for slot in 0..boxes.len() as u32 {
            let i = slot as usize;
            let is_settled =
                boxes[i] == previous[i] || !(boxes[i].is_valid() || previous[i].is_valid());
            assert!(
                is_settled || moved.contains(slot),
                "the box of slot {slot} is not settled"
            );
            assert!(
                is_settled || fat_boxes[i].contains(&boxes[i]) || self.escaped.contains(slot),
                "slot {slot} has escaped unnoticed"
            );
        }
        let is_moved = |&slot: &u32| moved.contains(slot);
        assert!(self.escaped.slots().iter().all(is_moved));
        self.candidates.validate(previous);
        let check = |mut kept: Vec<_>, boxes: &[Aabb<R, D>], what: &str| {
            let mut expected = overlapping(kernel, boxes, keys);
            kept.sort_unstable();
            expected.sort_unstable();
            assert!(kept == expected, "{what} are not the overlapping ones");
        };
        check(self.pairs().collect(), previous, "the held pairs");
        check(
            self.candidates.iter().collect(),
            fat_boxes,
            "the candidates",
        );
    }
}

/// The box of a slot without a proxy.
fn absent<R: Real, const D: usize>() -> Aabb<R, D> {
    Aabb::new([R::NAN; D], [R::NAN; D])
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
