//! What has stayed in its fat box, and what has not.
//!
//! When few proxies leave their fat boxes, sorting all of them again for each update would be a waste. So there are three
//! layers. The *base* is in the order that the last full run left behind. The *delta* is of all that have escaped since
//! then, in the order of the last run over the delta. And what is *recent* has escaped since that run; it is small and has
//! no order. An update looks the escaped up in the first two, and runs the kernel on the third alone. Entries of one layer
//! whose proxies have since escaped are outdated and passed over.
//!
//! A layer is sorted anew, and takes in all layers above it, once those have cost as much as sorting would. So the time is
//! never more than about twice what it would be if the best moment were known beforehand. Kernels that cannot look
//! boxes up have no layers.

use crate::slot_set::SlotSet;
use crate::stopwatch::{Phase, Stopwatch};
use crate::tuning::update::{COMPARE_ALL_UP_TO, DELTA_LOOKUP_COST, KEEP_SCRATCH_UP_TO};
use crate::{Aabb, BruteForce, GridSweep, InvalidInput, Kernel, PairFinder, RankSweep, Real, Work};

/// A kernel, and the layers if it can have them.
#[derive(Clone, Debug)]
pub(crate) enum Layers<R, const D: usize> {
    Grid(Box<GridLayers<R, D>>),
    Rank(Box<Unlayered<RankSweep<R, D>, R, D>>),
    Brute(Unlayered<BruteForce, R, D>),
}

impl<R: Real, const D: usize> Layers<R, D> {
    /// A kernel, with empty layers if it can have them. All are used if `are_used`, otherwise only the first.
    pub(super) fn new(kernel: Kernel, are_used: bool) -> Self {
        match kernel {
            Kernel::GridSweep => Self::Grid(Box::new(GridLayers::new(are_used))),
            Kernel::RankSweep => Self::Rank(Box::default()),
            Kernel::BruteForce => Self::Brute(Unlayered::default()),
        }
    }

    /// Whether escaped proxies may be looked up.
    pub(super) fn are_used(&self) -> bool {
        matches!(self, Self::Grid(layers) if layers.are_used)
    }

    /// What is above the base layer, if the base layer is sorted.
    pub(super) fn above_base(&self) -> Option<AboveBase> {
        match self {
            Self::Grid(layers) if layers.base.is_sorted => Some(layers.above_base()),
            _ => None,
        }
    }

    /// Appends to `found` the overlapping pairs among the valid boxes.
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

    /// Appends to `found` the overlapping pairs among the valid boxes that involve one of the `escaped`,
    /// which must be all that have changed since the last call of this or of [`find_all`](Self::find_all). The base layer
    /// must be [sorted](Self::above_base). Returns what it took.
    pub(super) fn find_escaped(
        &mut self,
        boxes: &[Aabb<R, D>],
        escaped: &SlotSet,
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) -> Work {
        match self {
            Self::Grid(layers) => layers.find_escaped(boxes, escaped, found, stopwatch),
            Self::Rank(_) | Self::Brute(_) => Work::default(),
        }
    }

    /// Makes the next proxy that escapes cause a full run.
    pub(super) fn forget(&mut self) {
        if let Self::Grid(layers) = self {
            layers.base.is_sorted = false;
        }
    }

    /// The number of size classes in the last full run, if it still holds.
    pub(crate) fn classes(&self) -> usize {
        match self {
            Self::Grid(layers) if layers.base.is_sorted => layers.base.order.class_count(),
            _ => 0,
        }
    }

    /// The strips of the first class in the last full run, if it still holds, along the axes that are cut.
    pub(crate) fn strips(&self) -> [u32; 2] {
        match self {
            Self::Grid(layers) if layers.base.is_sorted => layers.base.order.strips(),
            _ => [0; 2],
        }
    }

    /// How many slots are above the base layer: in the delta layer or recent.
    pub(crate) fn slots_above_base(&self) -> usize {
        match self {
            Self::Grid(layers) => layers.base.outdated.len(),
            Self::Rank(_) | Self::Brute(_) => 0,
        }
    }
}

/// The layers above the base, which the last full run has sorted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct AboveBase {
    /// What they have cost since the last full run, in boxes of a run.
    pub(super) spent: usize,
    /// How many slots are recent.
    pub(super) recent: usize,
}

/// The three layers.
#[derive(Clone, Debug)]
pub(crate) struct GridLayers<R, const D: usize> {
    /// If not, every search is a full run.
    are_used: bool,
    base: Layer<R, D>,
    delta: Layer<R, D>,
    recent: GridSweep<R, D>,
    /// Scratch: the members of a run.
    members: Vec<u32>,
}

/// A layer that has an order.
#[derive(Clone, Debug)]
struct Layer<R, const D: usize> {
    order: GridSweep<R, D>,
    is_sorted: bool,
    /// All that have escaped since it was sorted.
    outdated: SlotSet,
    /// What has been spent on the layers above it since then, in boxes of a run.
    spent: usize,
}

impl<R, const D: usize> GridLayers<R, D> {
    /// Empty layers. All are used if `are_used`, otherwise only the first.
    fn new(are_used: bool) -> Self {
        Self {
            are_used,
            base: Layer::default(),
            delta: Layer::default(),
            recent: GridSweep::default(),
            members: Vec::new(),
        }
    }
}

impl<R, const D: usize> Default for Layer<R, D> {
    fn default() -> Self {
        Self {
            order: GridSweep::default(),
            is_sorted: false,
            outdated: SlotSet::default(),
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
        self.outdated.clear();
        self.spent = 0;
        self.is_sorted = true;
        let run = self.order.find_among(boxes, members, found, stopwatch);
        run.unwrap_or_else(log_too_many);
    }

    /// Appends the pairs of the escaped that have a valid box with the members that are not outdated. All the escaped
    /// must be outdated.
    fn look_up(
        &mut self,
        boxes: &[Aabb<R, D>],
        escaped: &SlotSet,
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) {
        stopwatch.enter(Phase::Sweep);
        let queries = escaped.slots().iter().copied();
        let queries = queries.filter(|&slot| boxes[slot as usize].is_valid());
        let first = found.len();
        self.order.prepare_lookup();
        self.order.look_up(boxes, queries, found);
        let outdated = &self.outdated;
        retain_from(found, first, |[a, b]| {
            outdated.contains(a) != outdated.contains(b)
        });
    }
}

impl<R: Real, const D: usize> GridLayers<R, D> {
    fn above_base(&self) -> AboveBase {
        let recent = match self.delta.is_sorted {
            true => self.delta.outdated.len(),
            false => self.base.outdated.len(),
        };
        AboveBase {
            spent: self.base.spent,
            recent,
        }
    }

    fn find_escaped(
        &mut self,
        boxes: &[Aabb<R, D>],
        escaped: &SlotSet,
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) -> Work {
        let Self {
            base,
            delta,
            recent,
            members,
            ..
        } = self;
        for layer in [&mut *base, &mut *delta] {
            layer.outdated.make_room(boxes.len());
            for &slot in escaped.slots() {
                layer.outdated.insert(slot);
            }
        }
        base.look_up(boxes, escaped, found, stopwatch);
        let mut work = Work {
            looked_up: escaped.len(),
            ..Work::default()
        };

        let is_due = !delta.is_sorted || delta.spent > base.outdated.len();
        let due = if is_due {
            &base.outdated
        } else {
            &delta.outdated
        };
        members.clear();
        let slots = due.slots().iter().copied();
        members.extend(slots.filter(|&slot| boxes[slot as usize].is_valid()));
        base.spent += due.len();
        work.searched = due.len();
        let mut first = found.len();
        if is_due {
            delta.sort(boxes, members, found, stopwatch);
        } else {
            base.spent += DELTA_LOOKUP_COST * escaped.len();
            delta.spent += due.len();
            work.looked_up += escaped.len();
            delta.look_up(boxes, escaped, found, stopwatch);
            first = found.len();
            let run = recent.find_among(boxes, members, found, stopwatch);
            run.unwrap_or_else(log_too_many);
        }
        retain_from(found, first, |[a, b]| {
            escaped.contains(a) | escaped.contains(b)
        });
        work.found = found.len();
        work
    }

    fn find_all(
        &mut self,
        boxes: &[Aabb<R, D>],
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) {
        self.delta.is_sorted = false;
        self.delta.outdated.clear();
        if boxes.len() <= COMPARE_ALL_UP_TO {
            self.base.is_sorted = false;
            self.base.outdated.clear();
            stopwatch.enter(Phase::Sweep);
            compare_all(boxes, found);
            return;
        }
        collect_valid(boxes, &mut self.members);
        self.base.sort(boxes, &self.members, found, stopwatch);
        if boxes.len() > KEEP_SCRATCH_UP_TO {
            self.members = Vec::new();
            self.base.order.free_scratch();
        }
    }
}

/// A kernel without layers, which takes only slices of valid boxes.
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
        stopwatch.enter(Phase::Sweep);
        collect_valid(boxes, &mut self.slots);
        self.boxes.clear();
        self.boxes
            .extend(self.slots.iter().map(|&slot| boxes[slot as usize]));
        let run = self.kernel.find_pairs(&self.boxes, &mut self.pairs);
        run.unwrap_or_else(log_too_many);
        // The slots ascend, so the smaller of a pair stays the smaller.
        let pairs = self
            .pairs
            .iter()
            .map(|pair| pair.map(|i| self.slots[i as usize]));
        found.extend(pairs);
    }
}

/// Says why a run has found no pairs.
#[cold]
fn log_too_many(error: InvalidInput) {
    // All boxes are valid, so there are more than the kernel takes.
    log::error!("no pairs are found: {error}");
}

/// Appends the overlapping pairs among the valid ones of few boxes, each compared with each.
fn compare_all<R: Real, const D: usize>(boxes: &[Aabb<R, D>], found: &mut Vec<[u32; 2]>) {
    for (b, second) in (0..).zip(boxes) {
        // What is not valid overlaps nothing.
        let overlapping = (0..b)
            .zip(boxes)
            .filter(|(_, first)| first.overlaps(second));
        found.extend(overlapping.map(|(a, _)| [a, b]));
    }
}

/// Replaces `slots` by the slots that have a valid box, ascending.
fn collect_valid<R: Real, const D: usize>(boxes: &[Aabb<R, D>], slots: &mut Vec<u32>) {
    slots.clear();
    let numbered = (0..).zip(boxes);
    slots.extend(numbered.filter(|(_, b)| b.is_valid()).map(|(slot, _)| slot));
}

/// Drops the pairs from `first` on that do not meet the condition, without a branch.
#[inline(always)]
pub(super) fn retain_from(
    pairs: &mut Vec<[u32; 2]>,
    first: usize,
    mut keep: impl FnMut([u32; 2]) -> bool,
) {
    let mut kept = first;
    for i in first..pairs.len() {
        let pair = pairs[i];
        pairs[kept] = pair;
        kept += usize::from(keep(pair));
    }
    pairs.truncate(kept);
}
