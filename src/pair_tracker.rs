//! The pair set over time: proxies in, changes of the pair set out.
//!
//! A *proxy* is a box kept under a slot number. Between two calls of [`PairTracker::finish`] proxies are
//! placed, moved and removed; `finish` then reports how the set of overlapping pairs has changed.
//!
//! Each proxy has a reach around its box. The pairs whose reaches overlap are the candidates, and only when
//! proxies leave their reach must there be a search for new ones. In between, each candidate is held or not, as its
//! two boxes overlap or not. Neither hashing nor sorting is needed for that.

mod candidates;
mod layers;
mod links;
mod reach;
mod slot_set;
#[cfg(feature = "serde-serialize")]
mod snapshot;
#[cfg(test)]
mod tests;

use crate::stopwatch::Stopwatch;
use crate::{Aabb, Real, parallel};
use candidates::{Boxes, Candidates};
use reach::{Experience, Horizon};
use slot_set::SlotSet;

pub(crate) use layers::{GridLayers, Layers, Unlayered};
#[cfg(feature = "serde-serialize")]
pub(crate) use snapshot::TrackerSnapshot;

/// How many proxies a thread is given at a time.
const PART: usize = 1 << 14;

/// If fewer than one proxy in so many has moved, their candidates are looked for among all candidates.
const MANY: usize = 3;

/// Room for more pairs than this is given back after a full run.
const FEW: usize = 1 << 12;

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
    /// The reach of each proxy; all NaN where there is none, or none yet.
    reaches: Vec<Aabb<R, D>>,
    /// Slots whose boxes have changed since the last `finish`; some may occur more than once.
    moved: Vec<u32>,
    /// Those of them that have left their reach, have none yet, or are gone.
    escaped: SlotSet,
    horizon: Horizon,
    /// For how many moves to look ahead, whatever comes of it.
    pub(crate) fixed_foresight: Option<u16>,
    full_runs: u64,
    candidates: Candidates,
    /// Scratch: the candidates found by the kernel.
    found: Vec<[u32; 2]>,
    pub(crate) stopwatch: Stopwatch,
}

impl<R, const D: usize> Default for PairTracker<R, D> {
    fn default() -> Self {
        Self {
            boxes: Vec::new(),
            previous: Vec::new(),
            reaches: Vec::new(),
            moved: Vec::new(),
            escaped: SlotSet::default(),
            horizon: Horizon::default(),
            fixed_foresight: None,
            full_runs: 0,
            candidates: Candidates::default(),
            found: Vec::new(),
            stopwatch: Stopwatch::default(),
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

    /// The box under this slot; all NaN if there is no proxy.
    #[inline(always)]
    pub(crate) fn slot_box(&self, slot: u32) -> Aabb<R, D> {
        match self.boxes.get(slot as usize) {
            Some(aabb) => *aabb,
            None => Self::absent(),
        }
    }

    /// Places or moves the proxy of a slot. `aabb` must be valid.
    #[inline(always)]
    pub(crate) fn place(&mut self, slot: u32, aabb: Aabb<R, D>) {
        debug_assert!(aabb.is_valid());
        let index = slot as usize;
        if index >= self.boxes.len() {
            self.make_room(index + 1);
        }
        self.boxes[index] = aabb;
        self.moved.push(slot);
        if !self.reaches[index].contains(&aabb) {
            self.escaped.insert(slot);
        }
    }

    /// The boxes and the reaches of all slots, to move proxies where they are. Each move is to be
    /// [noted](Self::note).
    pub(crate) fn boxes_and_reaches(&mut self) -> (&mut [Aabb<R, D>], &[Aabb<R, D>]) {
        (&mut self.boxes, &self.reaches)
    }

    /// Takes note of proxies that were moved, and of those of them that have left their reach.
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

    /// Makes room for so many slots, which must be more than there were.
    #[cold]
    pub(crate) fn make_room(&mut self, slots: usize) {
        for boxes in [&mut self.boxes, &mut self.previous, &mut self.reaches] {
            boxes.resize(slots, Self::absent());
        }
    }

    /// Ends the pairs of a proxy with a [`PairChange::Deleted`] each, and forgets it.
    pub(crate) fn lift(&mut self, slot: u32) {
        let index = slot as usize;
        if index < self.boxes.len() {
            self.boxes[index] = Self::absent();
            self.reaches[index] = Self::absent();
            self.moved.push(slot);
            self.escaped.insert(slot);
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
        !self.moved.is_empty()
    }

    /// The held pairs, by slots, smaller first.
    pub(crate) fn pairs(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.candidates.held()
    }

    /// The number of held pairs.
    pub(crate) fn pair_count(&self) -> usize {
        self.candidates.held_count()
    }

    /// The number of pairs whose reaches overlap.
    pub(crate) fn candidate_count(&self) -> usize {
        self.candidates.len()
    }

    /// For how many moves ahead it searches.
    pub(crate) fn foresight(&self) -> u32 {
        self.horizon.moves()
    }

    /// How often it has searched for all pairs.
    pub(crate) fn full_runs(&self) -> u64 {
        self.full_runs
    }

    /// Goes on from the state of another one, which was read, but with settings of its own.
    #[cfg(feature = "serde-serialize")]
    pub(crate) fn resume(&mut self, state: Self, full_runs: u64) {
        *self = Self {
            stopwatch: std::mem::take(&mut self.stopwatch),
            fixed_foresight: self.fixed_foresight,
            full_runs,
            ..state
        };
    }

    /// The slots that have a proxy, with their boxes.
    pub(crate) fn proxies(&self) -> impl Iterator<Item = (u32, &Aabb<R, D>)> {
        (0..).zip(&self.boxes).filter(|(_, b)| b.is_valid())
    }

    /// Brings the pairs up to date and reports what has changed since the last call.
    ///
    /// Costs nothing when nothing was touched. Otherwise the candidates of what has moved are looked at, or all of
    /// them in order if that is most of them. What has left its reach is looked up in about **O(log n)** each, and if
    /// that is much, there is a run of the kernel over all proxies.
    pub(crate) fn finish(&mut self, layers: &mut Layers<R, D>, mut report: impl FnMut(PairChange)) {
        if !self.is_touched() {
            return;
        }
        let Self {
            boxes,
            previous,
            reaches,
            moved,
            escaped,
            horizon,
            fixed_foresight,
            full_runs,
            candidates,
            found,
            stopwatch,
        } = self;
        let mut lap = stopwatch.start();
        let report = &mut report;
        let both = Boxes {
            now: &boxes[..],
            before: &previous[..],
        };
        found.clear();
        if layers.is_full_run_due(escaped.slots().len(), boxes.len()) {
            let slots = boxes.len() as f64;
            let held = candidates.held_count();
            let experience = Experience {
                pairs: held as f64 / slots,
                excess: (candidates.len() - held) as f64 / slots,
                cost: layers.cost_per_update(boxes.len()),
            };
            *full_runs += 1;
            match fixed_foresight {
                Some(moves) => *horizon = Horizon::fixed(*moves),
                None => horizon.adapt(moved, boxes, previous, experience),
            }
            renew_reaches(reaches, &both, moved, *horizon);
            found.reserve_exact(candidates.len() + candidates.len() / 8);
            stopwatch.lap(lap, |times| &mut times.difference);
            layers.find_all(reaches, found, stopwatch);
            lap = stopwatch.start();
            let mut is_over = fixed_foresight.is_some();
            while !is_over && Horizon::are_too_many(found.len(), boxes.len(), held) {
                horizon.shorten();
                // Also if it was so before: what has not moved since may have its reach from an earlier time.
                is_over = !horizon.is_any();
                for (reach, (now, before)) in reaches.iter_mut().zip(boxes.iter().zip(&*previous)) {
                    *reach = horizon.reach(now, before);
                }
                *found = Vec::new();
                stopwatch.lap(lap, |times| &mut times.difference);
                layers.find_all(reaches, found, stopwatch);
                lap = stopwatch.start();
            }
            candidates.replace(found, &both, report);
            if found.capacity() > FEW {
                *found = Vec::new();
            }
        } else {
            for &slot in escaped.slots() {
                let i = slot as usize;
                reaches[i] = horizon.reach(&boxes[i], &previous[i]);
            }
            stopwatch.lap(lap, |times| &mut times.difference);
            layers.find_changed(reaches, escaped, found, stopwatch);
            lap = stopwatch.start();
            if moved.len() < boxes.len() / MANY {
                candidates.refresh_some(escaped, moved, &both, report);
            } else {
                candidates.refresh_all(escaped, &both, report);
            }
            candidates.extend(found, &both, report);
            let held = candidates.held_count();
            let are_too_many = Horizon::are_too_many(candidates.len(), boxes.len(), held);
            if are_too_many && fixed_foresight.is_none() {
                horizon.shorten();
                layers.forget();
            }
        }
        self.settle();
        self.stopwatch.lap(lap, |times| &mut times.difference);
    }

    /// Makes the present boxes the previous ones.
    fn settle(&mut self) {
        if self.moved.len() > self.boxes.len() / MANY {
            let chunks = self.previous.chunks_mut(PART).zip(self.boxes.chunks(PART));
            let mut parts: Vec<_> = chunks.collect();
            parallel::for_each(&mut parts, |(previous, boxes)| {
                previous.copy_from_slice(boxes)
            });
        } else {
            for &slot in &self.moved {
                self.previous[slot as usize] = self.boxes[slot as usize];
            }
        }
        self.moved.clear();
        self.escaped.clear();
    }

    /// Panics unless the held pairs are exactly those that overlap, by a full run of a fresh kernel, and all
    /// that is kept besides is in order.
    pub(crate) fn validate(&self, layers: &mut Layers<R, D>) {
        assert!(!self.is_touched(), "an update was not finished");
        assert_eq!(self.boxes.len(), self.previous.len());
        assert_eq!(self.boxes.len(), self.reaches.len());
        for (slot, (now, before)) in self.boxes.iter().zip(&self.previous).enumerate() {
            let is_settled = now == before || !(now.is_valid() || before.is_valid());
            assert!(is_settled, "the box of slot {slot} is not settled");
        }
        for (slot, (aabb, reach)) in self.boxes.iter().zip(&self.reaches).enumerate() {
            let is_sound = reach.contains(aabb) || !(aabb.is_valid() || reach.is_valid());
            assert!(is_sound, "the box of slot {slot} is not in its reach");
        }
        self.candidates.validate(&self.boxes);
        let mut check = |mut kept: Vec<_>, boxes: &[Aabb<R, D>], what: &str| {
            let mut expected = Vec::new();
            layers.find_all(boxes, &mut expected, &mut Stopwatch::default());
            kept.sort_unstable();
            expected.sort_unstable();
            assert!(kept == expected, "{what} are not the overlapping ones");
        };
        check(self.pairs().collect(), &self.boxes, "the held pairs");
        check(
            self.candidates.iter().collect(),
            &self.reaches,
            "the candidates",
        );
    }
}

/// Gives the moved proxies new reaches.
fn renew_reaches<R: Real, const D: usize>(
    reaches: &mut [Aabb<R, D>],
    boxes: &Boxes<R, D>,
    moved: &[u32],
    horizon: Horizon,
) {
    if moved.len() < reaches.len() / MANY {
        for &slot in moved {
            let i = slot as usize;
            reaches[i] = horizon.reach(&boxes.now[i], &boxes.before[i]);
        }
        return;
    }
    let boxes = boxes.now.chunks(PART).zip(boxes.before.chunks(PART));
    let mut parts: Vec<_> = reaches.chunks_mut(PART).zip(boxes).collect();
    parallel::for_each(&mut parts, |(reaches, (now, before))| {
        for (reach, (now, before)) in reaches.iter_mut().zip(now.iter().zip(*before)) {
            // The others have not moved, or came back at once.
            if now != before || !reach.contains(now) {
                *reach = horizon.reach(now, before);
            }
        }
    });
}
