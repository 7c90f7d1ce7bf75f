//! What rests and what moves.
//!
//! When few proxies move, sorting all of them again for each update would be a waste. So there are two
//! layers: the *resting* one, in the order that the last full run left behind, and the *moving* one, of all
//! proxies touched since. An update then looks the touched ones up in the resting layer, and runs the kernel
//! on the moving layer alone. Entries of the resting layer whose proxies belong to the moving one are stale
//! and passed over.
//!
//! Once the moving layer has cost as much as a full run, because it is full of proxies that have come to
//! rest, there is a full run, after which nothing moves. Kernels that cannot look boxes up have no layers.

use super::slot_set::SlotSet;
use crate::{Aabb, BruteForce, GridSweep, PairFinder, RankSweep, Real};

/// Looking a proxy up costs about as much as this many proxies in a full run.
const LOOKUP_COST: usize = 4;

/// Which pairs [`Layers::find`] has found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Found {
    /// Every overlapping pair.
    All,
    /// Every overlapping pair of which one proxy at least was touched.
    OfTouched,
}

/// A kernel, and the layers if it can have them.
#[derive(Clone, Debug)]
pub(crate) enum Layers<R, const D: usize> {
    Grid(Box<GridLayers<R, D>>),
    Rank(Box<Unlayered<RankSweep<R, D>, R, D>>),
    Brute(Unlayered<BruteForce, R, D>),
}

impl<R: Real, const D: usize> Layers<R, D> {
    /// Appends to `found` the overlapping pairs among the valid ones of `boxes`, or of those only that
    /// involve one of the `touched`, which must be all that have changed since the last call.
    pub(crate) fn find(
        &mut self,
        boxes: &[Aabb<R, D>],
        touched: &SlotSet,
        found: &mut Vec<[u32; 2]>,
    ) -> Found {
        match self {
            Self::Grid(layers) => layers.find(boxes, touched, found),
            Self::Rank(kernel) => kernel.find(boxes, found),
            Self::Brute(kernel) => kernel.find(boxes, found),
        }
    }

    /// How many proxies are in the moving layer.
    pub(crate) fn moving(&self) -> usize {
        match self {
            Self::Grid(layers) => layers.moving.slots().len(),
            Self::Rank(_) | Self::Brute(_) => 0,
        }
    }
}

/// The two layers.
#[derive(Clone, Debug)]
pub(crate) struct GridLayers<R, const D: usize> {
    /// The order of the last full run, if there was one.
    resting: GridSweep<R, D>,
    is_sorted: bool,
    /// All that were touched since the last full run.
    moving: SlotSet,
    moving_kernel: GridSweep<R, D>,
    /// Proxies of the moving layer that had not moved, summed over the updates since the last full run.
    idle: usize,
    /// Scratch: the members of a run.
    members: Vec<u32>,
}

impl<R, const D: usize> Default for GridLayers<R, D> {
    fn default() -> Self {
        Self {
            resting: GridSweep::default(),
            is_sorted: false,
            moving: SlotSet::default(),
            moving_kernel: GridSweep::default(),
            idle: 0,
            members: Vec::new(),
        }
    }
}

impl<R: Real, const D: usize> GridLayers<R, D> {
    fn find(
        &mut self,
        boxes: &[Aabb<R, D>],
        touched: &SlotSet,
        found: &mut Vec<[u32; 2]>,
    ) -> Found {
        let touched_slots = touched.slots();
        // A bound on the number of proxies that costs no count.
        let proxies = boxes.len();
        let moving = self.moving.slots().len() + touched_slots.len();
        let is_costly = LOOKUP_COST * touched_slots.len() + moving > proxies;
        if !self.is_sorted || is_costly || self.idle > proxies {
            self.find_all(boxes, found);
            return Found::All;
        }
        for &slot in touched_slots {
            self.moving.insert(slot);
        }
        self.idle += self.moving.slots().len() - touched_slots.len();

        let valid = |slot: &u32| boxes[*slot as usize].is_valid();
        self.resting.prepare_lookup();
        let queries = touched_slots.iter().copied().filter(valid);
        let first = found.len();
        self.resting.look_up(boxes, queries, found);
        // Of each pair one was touched, and so is in the moving layer; the other one must not be.
        let moving = &self.moving;
        retain_from(found, first, |[a, b]| {
            moving.contains(a) != moving.contains(b)
        });

        self.members.clear();
        self.members
            .extend(moving.slots().iter().copied().filter(valid));
        let first = found.len();
        self.moving_kernel.find_among(boxes, &self.members, found);
        retain_from(found, first, |[a, b]| {
            touched.contains(a) | touched.contains(b)
        });
        Found::OfTouched
    }

    fn find_all(&mut self, boxes: &[Aabb<R, D>], found: &mut Vec<[u32; 2]>) {
        self.moving.clear();
        self.idle = 0;
        self.is_sorted = true;
        collect_valid(boxes, &mut self.members);
        self.resting.find_among(boxes, &self.members, found);
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
    fn find(&mut self, boxes: &[Aabb<R, D>], found: &mut Vec<[u32; 2]>) -> Found {
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
        Found::All
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
