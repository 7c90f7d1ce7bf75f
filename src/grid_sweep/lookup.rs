//! One box against boxes that are already sorted.
//!
//! Boxes of different size classes meet by look-ups, and so do the boxes of an update that have moved and those that have not.
//!
//! In each tube, entries ascend by `mins[0]`, and so does the running maximum of `maxs[0]`. So a binary search finds the first entry
//! to compare, for boxes of any sizes.
//!
//! Both the query and a member may reach several tubes. Their pair is reported in one of them: on each axis, in the later of the two strips
//! in which they begin. If the strips of the tube are known, that is where they are not ghosts on the same axis, as in the sweep.

use super::class::Class;
use super::entry::Owner;
use super::grid::TubeSpan;
use super::slab::{Slab, Tube};
use super::sweep::many;
use super::worker::Worker;
use crate::aabb::Aabb;
use crate::bit_set::ones;
use crate::lanes::LANES;
use crate::real::Real;
use crate::tuning::kernel::VISIT;

/// How many entries are compared between two looks at the budget.
const COMPARED_AT_ONCE: usize = 1024;

impl<R: Real, const D: usize> Class<R, D> {
    /// Emits the pair of the box `i` with every box of the class that it overlaps.
    pub(super) fn look_up(&self, boxes: &[Aabb<R, D>], i: u32, worker: &mut Worker) {
        let (slabs, aabb) = (&self.slabs, &boxes[i as usize]);
        let Some(near) = self.bounds.and_then(|bounds| aabb.within(&bounds)) else {
            return;
        };
        let span = self.grid.tube_span(&near);
        let query = (aabb, i, span);
        let [rows, columns] = span.beyond().map(|beyond| u64::from(beyond) + 1);
        let (reached, tubes) = (rows * columns, self.tubes() as u64);
        // Most of them may be empty, or not reached.
        worker.tally.compared += reached.min(tubes) as usize;
        if worker.is_budget_exceeded() {
            return;
        }
        if reached > tubes {
            for slab in slabs {
                for tube in &slab.tubes {
                    if tube.strips.is_none_or(|strips| span.contains(strips)) {
                        self.look_up_in_tube((slab, tube), query, None, worker);
                    }
                }
            }
            return;
        }
        // In this order for any number of slabs.
        let TubeSpan { first, last } = span;
        for row in first[0]..=last[0] {
            for column in first[1]..=last[1] {
                let strips = [row, column];
                let number = self.grid.tube(strips);
                let slab = &slabs[slabs.partition_point(|slab| slab.range.end <= number)];
                let position = slab.table[(number - slab.range.start) as usize];
                let tube = slab.tubes.get(position as usize);
                if let Some(tube) = tube.filter(|tube| tube.strips.is_none_or(|s| s == strips)) {
                    self.look_up_in_tube((slab, tube), query, Some(strips), worker);
                }
            }
        }
    }

    /// Emits the pairs of a query, a box with its index and the tubes that it reaches, with the entries of a tube: those that are at `strips`,
    /// or if that is `None`, those of all tubes that share the number.
    #[inline(always)]
    fn look_up_in_tube(
        &self,
        (slab, tube): (&Slab<R, D>, &Tube<R, D>),
        (aabb, index, span): (&Aabb<R, D>, u32, TubeSpan),
        strips: Option<[u32; 2]>,
        worker: &mut Worker,
    ) {
        if worker.is_budget_exceeded() {
            return;
        }
        worker.tally.compared += VISIT;
        if (aabb.maxs[0] < tube.bounds.mins[0]) | (aabb.mins[0] > tube.bounds.maxs[0]) {
            return;
        }
        let (columns, maxs) = (slab.columns(), &slab.running_maxs[tube.entries.clone()]);
        let mut start = tube.entries.start + maxs.partition_point(|&max| max < aabb.mins[0]);
        // A small box does not reach other tubes with the same number.
        let is_small = span.beyond().iter().all(|&beyond| beyond <= 1);
        let known = tube.strips.or(strips.filter(|_| is_small));
        let owner = known.map(|strips| Owner::of(index, strips, span.first));
        loop {
            let window = start..start.saturating_add(COMPARED_AT_ONCE);
            let (compared, is_done) = match owner {
                Some(owner) => columns.window::<true>(window, aabb, |first, hits| {
                    let others: &[Owner; LANES] = many(columns.owners, first);
                    worker.emit(hits, |lane| [owner, others[lane % LANES]]);
                }),
                None => columns.window::<true>(window, aabb, |first, hits| {
                    for lane in ones(hits) {
                        let other = columns.owners[first + lane];
                        let home = self.grid.tube_span(&columns.entry(first + lane)).first;
                        let later = [0, 1].map(|cut| home[cut].max(span.first[cut]));
                        let is_here =
                            later == other.strips(home) && strips.is_none_or(|s| s == later);
                        worker.emit_one(Owner(index), other, is_here);
                    }
                }),
            };
            worker.tally.compared += compared;
            if is_done || worker.is_budget_exceeded() {
                return;
            }
            start += compared;
        }
    }
}
