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
        let aabb = &boxes[i as usize];
        let Some(near) = self.bounds.and_then(|bounds| aabb.within(&bounds)) else {
            return;
        };
        let span = self.grid.tube_span(&near);
        let query = (aabb, i, span);
        let [rows, columns] = span.beyond().map(|beyond| u64::from(beyond) + 1);
        let (reached, tubes) = (rows * columns, self.tubes as u64);
        worker.tally.compared += reached.min(tubes);
        if worker.is_budget_exceeded() {
            return;
        }
        if reached > tubes {
            for slab in &self.slabs {
                let tubes = slab.tubes.iter();
                let reached = tubes.filter(|tube| tube.strips.is_none_or(|of| span.contains(of)));
                reached.for_each(|tube| self.look_up_in_tube((slab, tube), query, worker));
            }
            return;
        }
        let mut are_shared = false;
        // In this order for any number of slabs.
        for row in span.first[0]..=span.last[0] {
            for column in span.first[1]..=span.last[1] {
                if let Some((slab, tube)) = self.tube(self.grid.tube([row, column])) {
                    if tube.strips == Some([row, column]) {
                        self.look_up_in_tube((slab, tube), query, worker);
                    }
                    are_shared |= tube.strips.is_none();
                }
            }
        }
        if are_shared {
            self.look_up_in_shared_tubes(query, worker);
        }
    }

    /// Visits each tube once that shares its number with others.
    #[cold]
    fn look_up_in_shared_tubes(&self, query: (&Aabb<R, D>, u32, TubeSpan), worker: &mut Worker) {
        let TubeSpan { first, last } = query.2;
        let is_shared = |(_, tube): (_, &Tube<R, D>)| tube.strips.is_none();
        let mut numbers = Vec::new();
        for row in first[0]..=last[0] {
            let in_row = (first[1]..=last[1]).map(|column| self.grid.tube([row, column]));
            numbers.extend(in_row.filter(|&number| self.tube(number).is_some_and(is_shared)));
        }
        numbers.sort_unstable();
        numbers.dedup();
        for (slab, tube) in numbers.into_iter().filter_map(|number| self.tube(number)) {
            self.look_up_in_tube((slab, tube), query, worker);
        }
    }

    /// The tube with a number, if it has entries.
    fn tube(&self, number: u32) -> Option<(&Slab<R, D>, &Tube<R, D>)> {
        let slab = &self.slabs[self.slabs.partition_point(|slab| slab.range.end <= number)];
        let position = slab.table[(number - slab.range.start) as usize];
        Some((slab, slab.tubes.get(position as usize)?))
    }

    /// Emits the pairs of a query, a box with its index and its tubes, with the entries of a tube, or of all tubes that share its number.
    #[inline(always)]
    fn look_up_in_tube(
        &self,
        (slab, tube): (&Slab<R, D>, &Tube<R, D>),
        (aabb, index, span): (&Aabb<R, D>, u32, TubeSpan),
        worker: &mut Worker,
    ) {
        if worker.is_budget_exceeded() {
            return;
        }
        worker.tally.compared += VISIT as u64;
        if (aabb.maxs[0] < tube.bounds.mins[0]) | (aabb.mins[0] > tube.bounds.maxs[0]) {
            return;
        }
        let (columns, maxs) = (slab.columns(), &slab.running_maxs[tube.entries.clone()]);
        let mut start = tube.entries.start + maxs.partition_point(|&max| max < aabb.mins[0]);
        let owner = tube
            .strips
            .map(|strips| Owner::of(index, strips, span.first));
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
                        worker.emit_one(Owner(index), other, later == other.strips(home));
                    }
                }),
            };
            worker.tally.compared += compared as u64;
            if is_done || worker.is_budget_exceeded() {
                return;
            }
            start += compared;
        }
    }
}
