//! What has stayed in its fat box, and what has left it.
//!
//! When few boxes leave their fat boxes, sorting all of them again for each update would be a waste. So there are three
//! layers. The *base* is in the order that the last full run left behind. The *delta* is of all that have left since then, in the
//! order of the last run over the delta. And what is *recent* has left since that run; it is small and has no order. An update
//! looks the leavers up in the first two, and runs the kernel on the third alone. Entries of one layer that have left since are
//! outdated and passed over.
//!
//! A layer is sorted anew, and takes in all layers above it, once those have cost as much as sorting would. So the time is
//! never more than about twice what it would be if the best moment were known beforehand. Kernels that cannot look
//! boxes up have no layers: with them, every search is a full run.

use crate::aabb::Aabb;
use crate::grid_sweep::{GridSweep, retain_from};
use crate::kernel::Kernel;
use crate::pair_finder::PairFinder;
use crate::rank_sweep::RankSweep;
use crate::real::Real;
use crate::slot_set::SlotSet;
use crate::stats::{Stats, Work};
use crate::stopwatch::{Phase, Stopwatch};
use crate::tuning::update::{COMPARE_ALL_UP_TO, DELTA_LOOKUP_COST, KEEP_SCRATCH_UP_TO};

/// A kernel, and the layers if it can have them.
#[derive(Clone, Debug, Default)]
pub(super) struct Layers<R: Real, const D: usize> {
    kernel: Kernel,
    are_used: bool,
    base: Layer<R, D>,
    delta: Layer<R, D>,
    recent: GridSweep<R, D>,
    /// Scratch: the members of a run.
    members: Vec<u32>,
    rank_sweep: RankSweep<R, D>,
}

/// The layers above the base, which the last full run has sorted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct AboveBase {
    /// What they have cost since the last full run, in boxes of a run.
    pub(super) cost: usize,
    /// How many slots are recent.
    pub(super) recent: usize,
}

/// A layer that has an order.
#[derive(Clone, Debug, Default)]
struct Layer<R, const D: usize> {
    order: GridSweep<R, D>,
    is_sorted: bool,
    /// All that have left since it was sorted.
    outdated: SlotSet,
    /// What has been spent on the layers above it since then, in boxes of a run.
    cost: usize,
}

impl<R: Real, const D: usize> Layer<R, D> {
    /// Replaces the members, indices of valid boxes, and appends the overlapping pairs among them that are wanted. Returns how many are not.
    fn sort(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: &[u32],
        wanted: Option<impl Fn([u32; 2]) -> bool + Sync>,
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) -> usize {
        self.outdated.clear();
        self.cost = 0;
        self.is_sorted = true;
        self.order
            .find_among(boxes, members, wanted, found, stopwatch)
    }

    /// Appends the pairs of the leavers, which must have valid boxes and be outdated, with the members that are not outdated.
    fn look_up(
        &mut self,
        boxes: &[Aabb<R, D>],
        leavers: &[u32],
        may_meet: impl Fn([u32; 2]) -> bool + Sync,
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) {
        stopwatch.enter(Phase::Sweep);
        self.order.prepare_lookup();
        let outdated = &self.outdated;
        let is_current = |pair: [u32; 2]| {
            let [a, b] = pair.map(|slot| outdated.contains(slot));
            a != b && may_meet(pair)
        };
        self.order.look_up(boxes, leavers, is_current, found);
    }
}

impl<R: Real, const D: usize> Layers<R, D> {
    /// A kernel, with empty layers if it can have them and they are `wanted`.
    pub(super) fn new(kernel: Kernel, wanted: bool) -> Self {
        Self {
            kernel,
            are_used: wanted && kernel == Kernel::GridSweep,
            ..Self::default()
        }
    }

    /// What is above the base layer, if layers are used and the base layer is sorted, so that leavers may be looked up.
    pub(super) fn above_base(&self) -> Option<AboveBase> {
        let Self { base, delta, .. } = self;
        let newest = if delta.is_sorted { delta } else { base };
        (self.are_used && base.is_sorted).then_some(AboveBase {
            cost: base.cost,
            recent: newest.outdated.len(),
        })
    }

    /// Makes the next proxy that leaves its fat box cause a full run.
    pub(super) fn forget(&mut self) {
        self.base.is_sorted = false;
    }

    /// Fills in what it knows: how many slots are above the base layer, and the grid of the last full run, if it still holds.
    pub(super) fn describe(&self, stats: &mut Stats) {
        let Layer {
            order, is_sorted, ..
        } = &self.base;
        stats.above_base = self.base.outdated.len();
        stats.classes = if *is_sorted { order.class_count() } else { 0 };
        stats.strips = if *is_sorted { order.strips() } else { [0; 2] };
    }

    /// Appends to `found` the overlapping pairs among the valid boxes that are wanted. Returns how many are not.
    pub(super) fn find_all(
        &mut self,
        boxes: &[Aabb<R, D>],
        wanted: Option<impl Fn([u32; 2]) -> bool + Sync>,
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) -> usize {
        let first = found.len();
        self.base.is_sorted = false;
        self.base.outdated.clear();
        self.delta.is_sorted = false;
        self.delta.outdated.clear();
        match self.kernel {
            Kernel::GridSweep if boxes.len() > COMPARE_ALL_UP_TO => {
                collect_valid(boxes, &mut self.members);
                let members = &self.members;
                let unwanted = self.base.sort(boxes, members, wanted, found, stopwatch);
                if boxes.len() > KEEP_SCRATCH_UP_TO {
                    self.members = Vec::new();
                    self.base.order.free_scratch();
                }
                return unwanted;
            }
            Kernel::GridSweep | Kernel::BruteForce => {
                stopwatch.enter(Phase::Sweep);
                compare_all(boxes, found);
            }
            Kernel::RankSweep => {
                stopwatch.enter(Phase::Sweep);
                collect_valid(boxes, &mut self.members);
                let slots = &self.members;
                // It takes only slices of valid boxes.
                let valid: Vec<_> = slots.iter().map(|&slot| boxes[slot as usize]).collect();
                let mut pairs = Vec::new();
                // They are valid, and fewer than it takes.
                let _ = self.rank_sweep.find_pairs(&valid, &mut pairs);
                // The slots ascend, so the smaller of a pair stays the smaller.
                found.extend(pairs.iter().map(|pair| pair.map(|i| slots[i as usize])));
            }
        }
        let count = found.len();
        if let Some(wanted) = wanted {
            retain_from(found, first, wanted);
        }
        count - found.len()
    }

    /// Appends to `found` the overlapping pairs among the valid boxes that may meet and involve one of the `leavers`, which must be all that
    /// have changed since the last search. The base layer must be [sorted](Self::above_base). Returns what it took.
    pub(super) fn find_leavers(
        &mut self,
        boxes: &[Aabb<R, D>],
        leavers: &SlotSet,
        may_meet: impl Fn([u32; 2]) -> bool + Sync,
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) -> Work {
        let is_new = |pair: [u32; 2]| {
            let [a, b] = pair.map(|slot| leavers.contains(slot));
            (a | b) && may_meet(pair)
        };
        let queries = leavers.slots().iter().copied();
        let queries: Vec<_> = queries
            .filter(|&slot| boxes[slot as usize].is_valid())
            .collect();
        for layer in [&mut self.base, &mut self.delta] {
            layer.outdated.make_room(boxes.len());
            for &slot in leavers.slots() {
                layer.outdated.insert(slot);
            }
        }
        self.base
            .look_up(boxes, &queries, &may_meet, found, stopwatch);
        let mut work = Work {
            looked_up: leavers.len(),
            ..Work::default()
        };

        let (base, delta) = (&mut self.base, &mut self.delta);
        let (recent, members) = (&mut self.recent, &mut self.members);
        let is_due = !delta.is_sorted || delta.cost > base.outdated.len();
        let due = match is_due {
            true => &base.outdated,
            false => &delta.outdated,
        };
        members.clear();
        let slots = due.slots().iter().copied();
        members.extend(slots.filter(|&slot| boxes[slot as usize].is_valid()));
        base.cost += due.len();
        work.searched = due.len();
        if is_due {
            delta.sort(boxes, members, Some(is_new), found, stopwatch);
        } else {
            base.cost += DELTA_LOOKUP_COST * leavers.len();
            delta.cost += due.len();
            work.looked_up += leavers.len();
            delta.look_up(boxes, &queries, &may_meet, found, stopwatch);
            recent.find_among(boxes, members, Some(is_new), found, stopwatch);
        }
        work.found = found.len();
        work
    }
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
