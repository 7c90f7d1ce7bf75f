//! What has stayed in its fat box, and what has left it.
//!
//! When few boxes leave their fat boxes, sorting all of them again for each update would be a waste. So there are two
//! layers. The *base* is in the order that the last full search left behind. What is *recent* has left its fat box since then; it is small,
//! and sorted in each update. An update looks the leavers up in the base, where entries that have left since are passed over, and runs the
//! kernel on what is recent.
//!
//! There is a full search once what is recent has cost as much as one. So the time is never more than about twice what it would be if the best
//! moment were known beforehand. Kernels that cannot look boxes up have no layers: with them, every search is a full search.

use crate::aabb::Aabb;
use crate::grid_sweep::GridSweep;
use crate::kernel::Kernel;
use crate::pair_finder::{PairFinder, retain_from};
use crate::rank_sweep::RankSweep;
use crate::real::Real;
use crate::slot_set::SlotSet;
use crate::stats::{Stats, Work};
use crate::stopwatch::{Phase, Stopwatch};
use crate::tuning::update::{COMPARE_ALL_UP_TO, KEEP_SCRATCH_UP_TO};

/// A kernel, and the layers if it can have them.
#[derive(Clone, Debug, Default)]
pub(super) struct Layers<R: Real, const D: usize> {
    kernel: Kernel,
    are_used: bool,
    /// In the order of the last full search.
    base: GridSweep<R, D>,
    is_base_sorted: bool,
    /// All that have left their fat boxes since then.
    outdated: SlotSet,
    /// What the layer above has cost since then, in boxes of a run.
    cost: usize,
    recent: GridSweep<R, D>,
    /// How many pairs of boxes overlap, wanted or not, as of the last full search.
    found: usize,
    /// Scratch: the members of a run.
    members: Vec<u32>,
    rank_sweep: RankSweep<R, D>,
}

/// There are far more pairs than foresight can be worth.
pub(super) struct TooMany;

/// The layer above the base, which the last full search has sorted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct AboveBase {
    /// What it has cost since the last full search, in boxes of a run.
    pub(super) cost: usize,
    /// How many slots are recent.
    pub(super) recent: usize,
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
        (self.are_used && self.is_base_sorted).then_some(AboveBase {
            cost: self.cost,
            recent: self.outdated.len(),
        })
    }

    /// Makes the next proxy that leaves its fat box cause a full search.
    pub(super) fn forget(&mut self) {
        self.is_base_sorted = false;
    }

    /// Fills in what it knows: how many slots are above the base layer, and the size classes of the last full search, if it still holds.
    pub(super) fn describe(&self, stats: &mut Stats) {
        stats.above_base = self.outdated.len();
        stats.classes = match self.is_base_sorted {
            true => self.base.class_count(),
            false => 0,
        };
    }

    /// Appends to `found` the overlapping pairs among the valid boxes that are wanted. Returns how many overlap, wanted or not, or that
    /// they are far more than last time, and that only some were found: more than there were, and `most`.
    pub(super) fn find_all(
        &mut self,
        boxes: &[Aabb<R, D>],
        wanted: Option<impl Fn([u32; 2]) -> bool + Sync>,
        most: usize,
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) -> Result<usize, TooMany> {
        let first = found.len();
        self.forget();
        self.outdated.clear();
        self.cost = 0;
        match self.kernel {
            Kernel::GridSweep if boxes.len() > COMPARE_ALL_UP_TO => {
                collect_valid(boxes, &mut self.members);
                let (members, most) = (&self.members, self.found.saturating_add(most));
                let overlapping = self
                    .base
                    .find_among(boxes, members, wanted, most, found, stopwatch);
                if overlapping > most {
                    return Err(TooMany);
                }
                self.found = overlapping;
                self.is_base_sorted = true;
                if boxes.len() > KEEP_SCRATCH_UP_TO {
                    self.members = Vec::new();
                    self.base.free_scratch();
                }
                return Ok(overlapping);
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
        let overlapping = found.len() - first;
        if let Some(wanted) = wanted {
            retain_from(found, first, wanted);
        }
        Ok(overlapping)
    }

    /// Appends to `found` the overlapping pairs among the valid boxes that may meet and involve one of the `leavers`, which must be all that
    /// have changed since the last search. The base layer must be [sorted](Self::above_base). Returns what it took, or that there are far
    /// more pairs than there were, and `most`, and that only some were found.
    pub(super) fn find_leavers(
        &mut self,
        boxes: &[Aabb<R, D>],
        leavers: &SlotSet,
        may_meet: impl Fn([u32; 2]) -> bool + Sync,
        most: usize,
        found: &mut Vec<[u32; 2]>,
        stopwatch: &mut Stopwatch,
    ) -> Result<Work, TooMany> {
        let is_new = |pair: [u32; 2]| {
            let [a, b] = pair.map(|slot| leavers.contains(slot));
            (a | b) && may_meet(pair)
        };
        let queries = leavers.slots().iter().copied();
        let queries: Vec<_> = queries
            .filter(|&slot| boxes[slot as usize].is_valid())
            .collect();
        let Self {
            base,
            outdated,
            recent,
            members,
            ..
        } = self;
        outdated.make_room(boxes.len());
        for &slot in leavers.slots() {
            outdated.insert(slot);
        }
        stopwatch.enter(Phase::Sweep);
        base.prepare_lookup();
        let is_current = |pair: [u32; 2]| {
            let [a, b] = pair.map(|slot| outdated.contains(slot));
            a != b && may_meet(pair)
        };
        let most = self.found.saturating_add(most);
        let tally = base.look_up(boxes, &queries, is_current, most, found);
        if tally.emitted > most {
            return Err(TooMany);
        }

        let slots = outdated.slots().iter().copied();
        members.clear();
        members.extend(slots.filter(|&slot| boxes[slot as usize].is_valid()));
        if recent.find_among(boxes, members, Some(is_new), most, found, stopwatch) > most {
            return Err(TooMany);
        }
        self.cost += outdated.len();
        Ok(Work {
            looked_up: leavers.len(),
            visited: tally.compared,
            searched: outdated.len(),
            found: found.len(),
            ..Work::default()
        })
    }
}

/// Appends the overlapping pairs among the valid ones of few boxes, each compared with each.
fn compare_all<R: Real, const D: usize>(boxes: &[Aabb<R, D>], found: &mut Vec<[u32; 2]>) {
    for (b, second) in (0..).zip(boxes) {
        // What is not valid overlaps nothing.
        let overlapping = (0..b)
            .zip(boxes)
            .filter(|(_, first)| first.intersects(second));
        found.extend(overlapping.map(|(a, _)| [a, b]));
    }
}

/// Replaces `slots` by the slots that have a valid box, ascending.
fn collect_valid<R: Real, const D: usize>(boxes: &[Aabb<R, D>], slots: &mut Vec<u32>) {
    slots.clear();
    let numbered = (0..).zip(boxes);
    slots.extend(numbered.filter(|(_, b)| b.is_valid()).map(|(slot, _)| slot));
}
