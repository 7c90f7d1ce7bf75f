//! The search for fat boxes that overlap, in two layers.
//!
//! The *base* keeps the order of the last full search. The *recent* boxes have left their fat boxes since then; they are few, and sorted in each
//! update. An update looks the leavers up in the base, skipping entries that are outdated, and runs the kernel on the recent boxes.

use super::policy::Work;
use crate::aabb::Aabb;
use crate::grid_sweep::GridSweep;
use crate::real::Real;
use crate::slot_set::SlotSet;
use crate::tuning::update::KEEP_SCRATCH_UP_TO;

/// Slots. Worlds of no more compare each box with each in a full search, and look nothing up. If larger: the number of comparisons is
/// quadratic. If smaller: choosing a grid and sorting into it takes longer than comparing, and so do look-ups.
const BRUTE_FORCE_UP_TO: usize = 16;

/// One slot in this many. If no more are not of one clique, the others need not all be searched. If larger: bodies with others around them are
/// searched. If smaller: where a body is most of a world, the others are all searched whenever one has left its fat box.
const FEW_OTHERS_ONE_IN: usize = 8;

/// The kernel for each layer.
#[derive(Clone, Debug, Default)]
pub(super) struct Layers<R: Real, const D: usize> {
    /// In the order of the last full search.
    base: GridSweep<R, D>,
    /// Otherwise the next proxy that leaves its fat box causes a full search.
    pub(super) is_base_sorted: bool,
    /// The slots that have left their fat boxes since then: the recent layer.
    outdated: SlotSet,
    recent: GridSweep<R, D>,
    /// How many pairs of fat boxes overlapped in the last full search, whether they may meet or not.
    overlapping: usize,
}

impl<R: Real, const D: usize> Layers<R, D> {
    /// The number of slots in the recent layer; `None` if the base layer is not sorted, so that nothing can be looked up.
    pub(super) fn recent(&self) -> Option<usize> {
        self.is_base_sorted.then_some(self.outdated.len())
    }

    /// Finds the overlapping pairs among the valid boxes that may meet; without a condition, all may. The list must be empty. `clique` gives the
    /// [clique](super::FilterKey::clique) of a slot. Returns how many overlap, whether they may meet or not, except within a clique that is [left
    /// out](leave_out); `None` if they are more than in the last full search by more than `most`, and only some were found.
    pub(super) fn find_all(
        &mut self,
        boxes: &[Aabb<R, D>],
        may_meet: Option<impl Fn([u32; 2]) -> bool + Sync>,
        clique: impl Fn(u32) -> Option<u32>,
        most: usize,
        found: &mut Vec<[u32; 2]>,
    ) -> Option<usize> {
        self.is_base_sorted = false;
        self.outdated.clear();
        if boxes.len() <= BRUTE_FORCE_UP_TO {
            for (b, second) in (0..).zip(boxes) {
                let before = (0..b).zip(boxes);
                let overlapping = before.filter(|(_, first)| first.intersects(second));
                found.extend(overlapping.map(|(a, _)| [a, b]));
            }
            let overlapping = found.len();
            if let Some(may_meet) = may_meet {
                found.retain(|&pair| may_meet(pair));
            }
            return Some(overlapping);
        }
        let mut members = Vec::with_capacity(boxes.len());
        let valid = (0..).zip(boxes).filter(|(_, b)| b.is_valid());
        members.extend(valid.map(|(slot, _)| slot));
        let all = members.len();
        if may_meet.is_some() {
            leave_out(&mut members, boxes, clique);
        }
        let most = self.overlapping.saturating_add(most);
        let listed = members.iter().copied();
        let base = &mut self.base;
        let overlapping = base.find_among(boxes, listed, true, may_meet, most, found);
        if overlapping > most {
            return None;
        }
        self.overlapping = overlapping;
        // Otherwise some might not be found by those that are looked up.
        self.is_base_sorted = members.len() == all;
        if boxes.len() > KEEP_SCRATCH_UP_TO {
            self.base.free_scratch();
        }
        Some(overlapping)
    }

    /// Finds the overlapping pairs among the valid boxes that may meet and have one of the `leavers`, which must be the only boxes that have
    /// changed since the last search. The base layer must be [sorted](Self::recent), and the list empty. Returns the work it took; `None` as in a full search.
    pub(super) fn find_pairs_of_leavers(
        &mut self,
        boxes: &[Aabb<R, D>],
        leavers: &SlotSet,
        may_meet: impl Fn([u32; 2]) -> bool + Sync,
        most: usize,
        found: &mut Vec<[u32; 2]>,
    ) -> Option<Work> {
        let is_valid = |&slot: &u32| boxes[slot as usize].is_valid();
        let outdated = &mut self.outdated;
        outdated.add(leavers.slots());
        let is_current = |pair: [u32; 2]| {
            let [a, b] = pair.map(|slot| outdated.contains(slot));
            a != b && may_meet(pair)
        };
        let is_new = |pair| leavers.has_any(pair) && may_meet(pair);
        let most = self.overlapping.saturating_add(most);
        let queries = leavers.slots().iter().copied().filter(is_valid);
        let queries: Vec<_> = queries.collect();
        let base = &self.base;
        let tally = base.look_up_queries(boxes, &queries, is_current, most, found);
        if tally.emitted > most {
            return None;
        }
        let members = outdated.slots().iter().copied().filter(is_valid);
        let recent = &mut self.recent;
        let overlapping = recent.find_among(boxes, members, false, Some(is_new), most, found);
        (overlapping <= most).then(|| Work {
            looked_up: leavers.len() as u64,
            visited: tally.compared,
            recent: outdated.len() as u64,
            found: found.len() as u64,
            ..Work::default()
        })
    }
}

/// If nearly all of these slots are of one clique, leaves out those of them that cannot meet another slot: whose boxes do not overlap the box
/// around all others. So a body of thousands of colliders that all overlap each other need not be searched. Leaves out none if few would be
/// left out. **O(slots)**.
fn leave_out<R: Real, const D: usize>(
    members: &mut Vec<u32>,
    boxes: &[Aabb<R, D>],
    clique: impl Fn(u32) -> Option<u32>,
) {
    let few = members.len() / FEW_OTHERS_ONE_IN;
    let sample = members.iter().step_by(few.max(1));
    let mut cliques: Vec<_> = sample.map(|&slot| clique(slot)).collect();
    cliques.sort_unstable();
    // If nearly all have one clique, it is in the middle.
    let middle = cliques.len() / 2;
    let Some(Some(most)) = cliques.get(middle) else {
        return;
    };
    let is_other = |slot: &&u32| clique(**slot) != Some(*most);
    if members.iter().filter(is_other).nth(few).is_some() {
        return;
    }
    let around = |is_in: &dyn Fn(&&u32) -> bool| {
        let slots = members.iter().filter(is_in);
        slots.fold(Aabb::EMPTY, |all, &slot| all.around(&boxes[slot as usize]))
    };
    let all = around(&|slot| !is_other(slot));
    let overlap = |slot: &&u32, aabb| boxes[**slot as usize].intersects(aabb);
    let reach = around(&|slot| is_other(slot) && overlap(slot, &all));
    let enters = |slot: &&u32| is_other(slot) || overlap(slot, &reach);
    let entering = members.iter().filter(enters).copied();
    let entering: Vec<_> = entering.take(few + 1).collect();
    if entering.len() <= few {
        *members = entering;
    }
}
