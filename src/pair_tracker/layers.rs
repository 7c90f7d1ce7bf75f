//! What rests and what moves.
//!
//! When few boxes change, sorting all of them again for each update would be a waste. So there are three
//! layers. The *resting* one is in the order that the last run over all boxes left behind. The *moving* one is of
//! all that have changed since then, in the order of the last run over those. And the *recent* one is of all that
//! have changed since that; it is small and has no order. An update looks the changed boxes up in the first two, and
//! runs the kernel on the third alone. Entries of one layer whose boxes belong to the next are stale and passed over.
//!
//! A layer is sorted anew, and takes in all that follow, once the following ones have cost as much as that: so never
//! more than about twice as much time is spent as if it had been known beforehand when it pays. Kernels that cannot
//! look boxes up have no layers.

#[cfg(feature = "serde-serialize")]
mod snapshot;

use super::slot_set::SlotSet;
use crate::stopwatch::Stopwatch;
use crate::{Aabb, BruteForce, GridSweep, PairFinder, RankSweep, Real};
#[cfg(feature = "serde-serialize")]
pub(super) use snapshot::LayersSnapshot;

/// Looking a box up among all others costs about as much as so many boxes in a run over all of them.
const LOOKUP_COST: usize = 6;

/// Looking it up in the moving layer, which is smaller and nearer.
const SECOND_LOOKUP_COST: usize = 2;

/// It is a wave if so many times as many boxes change in one update as usual, and one in so many of all.
const WAVE: [u64; 2] = [8, 24];

/// With more boxes than this, what only a run over all of them needs is given back after it: it would be the larger part
/// of all memory, unused in nine updates of ten.
const MANY: usize = 1 << 12;

/// A kernel, and the layers if it can have them.
#[derive(Clone, Debug)]
pub(crate) enum Layers<R, const D: usize> {
    Grid(Box<GridLayers<R, D>>),
    Rank(Box<Unlayered<RankSweep<R, D>, R, D>>),
    Brute(Unlayered<BruteForce, R, D>),
}

impl<R: Real, const D: usize> Layers<R, D> {
    /// Whether a run over all boxes is the best to do, after so many of them have changed.
    pub(super) fn is_full_run_due(&self, changed: usize, boxes: usize) -> bool {
        match self {
            Self::Grid(layers) => layers.is_full_run_due(changed, boxes),
            Self::Rank(_) | Self::Brute(_) => changed > 0,
        }
    }

    /// Appends to `found` the overlapping pairs among the valid ones of `boxes`.
    pub(super) fn find_all(
        &mut self,
        boxes: &[Aabb<R, D>],
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) {
        match self {
            Self::Grid(layers) => layers.find_all(boxes, found, stopwatch),
            Self::Rank(kernel) => kernel.find_all(boxes, found, stopwatch),
            Self::Brute(kernel) => kernel.find_all(boxes, found, stopwatch),
        }
    }

    /// Appends to `found` the overlapping pairs among the valid ones of `boxes` that involve one of the `changed`,
    /// which must be all that have changed since the last call of this or of [`find_all`](Self::find_all), and few
    /// enough for no [full run](Self::is_full_run_due) to be due.
    pub(super) fn find_changed(
        &mut self,
        boxes: &[Aabb<R, D>],
        changed: &SlotSet,
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) {
        if let Self::Grid(layers) = self {
            layers.find_changed(boxes, changed, found, stopwatch);
        }
    }

    /// What searching has cost in each update since the last full run, that one included, if another is made now. In
    /// full runs; `None` if there was none.
    pub(super) fn cost_per_update(&self, boxes: usize) -> Option<f64> {
        match self {
            Self::Grid(layers) if layers.resting.is_sorted => {
                let lookups = LOOKUP_COST as f64 * layers.changes as f64 / boxes as f64;
                Some((1.0 + lookups) / (layers.updates + 1) as f64)
            }
            _ => None,
        }
    }

    /// Makes the next change cause a full run.
    pub(super) fn forget(&mut self) {
        if let Self::Grid(layers) = self {
            layers.resting.is_sorted = false;
        }
    }

    /// The classes of sizes in the last full run, if it still holds.
    pub(crate) fn classes(&self) -> usize {
        match self {
            Self::Grid(layers) if layers.resting.is_sorted => layers.resting.order.class_count(),
            _ => 0,
        }
    }

    /// The strips of the first class in the last full run, if it still holds, along the axes that are cut.
    pub(crate) fn strips(&self) -> [u32; 2] {
        match self {
            Self::Grid(layers) if layers.resting.is_sorted => layers.resting.order.strips(),
            _ => [0; 2],
        }
    }

    /// How many proxies are in the moving layer.
    pub(crate) fn moving(&self) -> usize {
        match self {
            Self::Grid(layers) => layers.resting.stale.slots().len(),
            Self::Rank(_) | Self::Brute(_) => 0,
        }
    }
}

/// The three layers.
#[derive(Clone, Debug)]
pub(crate) struct GridLayers<R, const D: usize> {
    /// If not, every search is a full run.
    are_used: bool,
    resting: Layer<R, D>,
    moving: Layer<R, D>,
    recent: GridSweep<R, D>,
    /// The updates since the last full run, and how many boxes have changed in them.
    updates: u64,
    changes: u64,
    /// Scratch: the members of a run.
    members: Vec<u32>,
}

/// A layer that has an order.
#[derive(Clone, Debug)]
struct Layer<R, const D: usize> {
    order: GridSweep<R, D>,
    is_sorted: bool,
    /// All that have changed since it was sorted.
    stale: SlotSet,
    /// What has been spent on the following layers since then, in boxes of a run.
    spent: usize,
}

impl<R, const D: usize> Default for GridLayers<R, D> {
    fn default() -> Self {
        Self::new(true)
    }
}

impl<R, const D: usize> GridLayers<R, D> {
    /// Empty layers, which are used, or only the first of them.
    pub(crate) fn new(are_used: bool) -> Self {
        Self {
            are_used,
            resting: Layer::default(),
            moving: Layer::default(),
            recent: GridSweep::default(),
            updates: 0,
            changes: 0,
            members: Vec::new(),
        }
    }
}

impl<R, const D: usize> Default for Layer<R, D> {
    fn default() -> Self {
        Self {
            order: GridSweep::default(),
            is_sorted: false,
            stale: SlotSet::default(),
            spent: 0,
        }
    }
}

impl<R: Real, const D: usize> Layer<R, D> {
    /// Replaces the members, indices of valid boxes, and appends the overlapping pairs among them.
    fn sort(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: &[u32],
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) {
        self.stale.clear();
        self.spent = 0;
        self.is_sorted = true;
        self.order.find_among(boxes, members, found, stopwatch);
    }

    /// Appends the pairs of the valid ones among the changed with those members that are not stale. All the changed
    /// must be.
    fn look_up(
        &mut self,
        boxes: &[Aabb<R, D>],
        changed: &SlotSet,
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) {
        let lap = stopwatch.start();
        let queries = changed.slots().iter().copied();
        let queries = queries.filter(|&slot| boxes[slot as usize].is_valid());
        let first = found.len();
        self.order.prepare_lookup();
        self.order.look_up(boxes, queries, found);
        let stale = &self.stale;
        retain_from(found, first, |[a, b]| {
            stale.contains(a) != stale.contains(b)
        });
        stopwatch.lap(lap, |times| &mut times.sweep);
    }
}

impl<R: Real, const D: usize> GridLayers<R, D> {
    fn is_full_run_due(&self, changed: usize, boxes: usize) -> bool {
        let [times, part] = WAVE;
        // Reaches that were made at the same time tend to be left at the same time; a run makes them all anew.
        let [count, all] = [changed as u64, boxes as u64];
        let is_wave = count * self.updates > times * self.changes && part * count > all;
        let is_costly = LOOKUP_COST * changed > boxes || self.resting.spent > boxes;
        changed > 0 && (!self.are_used || !self.resting.is_sorted || is_costly || is_wave)
    }

    fn find_changed(
        &mut self,
        boxes: &[Aabb<R, D>],
        changed: &SlotSet,
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) {
        let count = changed.slots().len();
        self.updates += 1;
        self.changes += count as u64;
        if count == 0 {
            return;
        }
        let Self {
            resting,
            moving,
            recent,
            members,
            ..
        } = self;
        for &slot in changed.slots() {
            resting.stale.insert(slot);
            moving.stale.insert(slot);
        }
        resting.look_up(boxes, changed, found, stopwatch);

        let is_due = !moving.is_sorted || moving.spent > resting.stale.slots().len();
        let due = if is_due {
            &resting.stale
        } else {
            &moving.stale
        };
        members.clear();
        let slots = due.slots().iter().copied();
        members.extend(slots.filter(|&slot| boxes[slot as usize].is_valid()));
        resting.spent += due.slots().len();
        let mut first = found.len();
        if is_due {
            moving.sort(boxes, members, found, stopwatch);
        } else {
            resting.spent += SECOND_LOOKUP_COST * count;
            moving.spent += due.slots().len();
            moving.look_up(boxes, changed, found, stopwatch);
            first = found.len();
            recent.find_among(boxes, members, found, stopwatch);
        }
        retain_from(found, first, |[a, b]| {
            changed.contains(a) | changed.contains(b)
        });
    }

    fn find_all(
        &mut self,
        boxes: &[Aabb<R, D>],
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) {
        self.moving.is_sorted = false;
        self.moving.stale.clear();
        self.updates = 0;
        self.changes = 0;
        collect_valid(boxes, &mut self.members);
        self.resting.sort(boxes, &self.members, found, stopwatch);
        if boxes.len() > MANY {
            self.members = Vec::new();
            self.resting.order.free_scratch();
        }
    }
}

/// A kernel without layers, which knows slices of valid boxes only.
#[derive(Clone, Debug)]
pub(crate) struct Unlayered<K, R, const D: usize> {
    kernel: K,
    /// Scratch: the valid boxes, their slots and their pairs.
    boxes: Vec<Aabb<R, D>>,
    slots: Vec<u32>,
    pairs: Vec<[u32; 2]>,
}

impl<K: Default, R, const D: usize> Default for Unlayered<K, R, D> {
    fn default() -> Self {
        Self {
            kernel: K::default(),
            boxes: Vec::new(),
            slots: Vec::new(),
            pairs: Vec::new(),
        }
    }
}

impl<K: PairFinder<R, D>, R: Real, const D: usize> Unlayered<K, R, D> {
    fn find_all(
        &mut self,
        boxes: &[Aabb<R, D>],
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) {
        let lap = stopwatch.start();
        collect_valid(boxes, &mut self.slots);
        self.boxes.clear();
        self.boxes
            .extend(self.slots.iter().map(|&slot| boxes[slot as usize]));
        if let Err(error) = self.kernel.find_pairs(&self.boxes, &mut self.pairs) {
            // All boxes are valid, so it is their number that is out of the kernel's reach.
            log::error!("no pairs are found: {error}");
        }
        // The slots ascend, so the smaller of a pair stays the smaller.
        let pairs = self
            .pairs
            .iter()
            .map(|pair| pair.map(|i| self.slots[i as usize]));
        found.extend(pairs);
        stopwatch.lap(lap, |times| &mut times.sweep);
    }
}

/// Replaces `slots` by those of the valid boxes, ascending.
fn collect_valid<R: Real, const D: usize>(boxes: &[Aabb<R, D>], slots: &mut Vec<u32>) {
    slots.clear();
    let numbered = (0..).zip(boxes);
    slots.extend(numbered.filter(|(_, b)| b.is_valid()).map(|(slot, _)| slot));
}

/// Keeps of the pairs from `first` on those that meet the condition.
fn retain_from(pairs: &mut Vec<[u32; 2]>, first: usize, mut keep: impl FnMut([u32; 2]) -> bool) {
    let mut kept = first;
    for i in first..pairs.len() {
        let pair = pairs[i];
        pairs[kept] = pair;
        kept += usize::from(keep(pair));
    }
    pairs.truncate(kept);
}
