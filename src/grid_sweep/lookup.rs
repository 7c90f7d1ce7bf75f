//! One box against boxes that are already sorted.
//!
//! This is how boxes much larger than the rest meet the rest: a box that spans more than two strips on an
//! axis gets no entries, because there could be any number of them. And it is how a few boxes that have
//! moved meet the many that have not.
//!
//! Entries are sorted by `mins[0]`, and the running maximum of `maxs[0]` ascends too. So in each occupied
//! tube that the box spans, a binary search finds the first entry to look at, for boxes of any sizes.

use super::ghosts::owner_in;
use super::grid::{Grid, TubeSpan};
use super::sweep::Emitter;
use super::tubes::{NOWHERE, Tube, Tubes};
use crate::tuning::kernel::TABLE_LOOKUPS_UP_TO;
use crate::{Aabb, Real};

impl<R: Real, const D: usize> Tubes<R, D> {
    /// Whether [`look_up`](Self::look_up) may be called.
    pub(super) fn is_prepared(&self) -> bool {
        self.running_maxs.len() == self.owners.len()
    }

    /// Prepares for [`look_up`](Self::look_up), until the next build.
    pub(super) fn prepare_lookup(&mut self) {
        if self.is_prepared() {
            return;
        }
        self.running_maxs.extend_from_slice(&self.maxs[0]);
        for tube in &self.tubes {
            let mut running = R::NEG_INFINITY;
            for max in &mut self.running_maxs[tube.start as usize..tube.end as usize] {
                running = if *max > running { *max } else { running };
                *max = running;
            }
        }
    }

    /// Reports every box that overlaps a given one, once, however many entries it has.
    pub(super) fn look_up(
        &self,
        grid: &Grid<R>,
        aabb: &Aabb<R, D>,
        owner: u32,
        emitter: &mut Emitter,
    ) {
        let span = grid.tube_span(aabb);
        let [rows, columns] = [0, 1].map(|cut| u64::from(span.last[cut] - span.first[cut]) + 1);
        if !self.table.is_empty() && rows * columns <= TABLE_LOOKUPS_UP_TO {
            self.look_up_in_table(grid, &span, aabb, owner, emitter);
        } else {
            self.look_up_by_searching(&span, aabb, owner, emitter);
        }
    }

    /// For a box that spans few tubes.
    fn look_up_in_table(
        &self,
        grid: &Grid<R>,
        span: &TubeSpan,
        aabb: &Aabb<R, D>,
        owner: u32,
        emitter: &mut Emitter,
    ) {
        let columns = grid.axes[1].last + 1;
        for row in span.first[0]..=span.last[0] {
            for column in span.first[1]..=span.last[1] {
                let tube = (row * columns + column).wrapping_sub(self.range.start) as usize;
                // Tubes of another slab are beyond the end.
                let position = self.table.get(tube).copied().unwrap_or(NOWHERE);
                if let Some(tube) = self.tubes.get(position as usize) {
                    self.look_up_in(tube, span, aabb, owner, emitter);
                }
            }
        }
    }

    /// For a box that may span any number of tubes, few of which need be occupied.
    fn look_up_by_searching(
        &self,
        span: &TubeSpan,
        aabb: &Aabb<R, D>,
        owner: u32,
        emitter: &mut Emitter,
    ) {
        let mut rest = &self.tubes[..];
        let mut row = span.first[0];
        // Each row that has tubes, and in it the tubes between the columns.
        while row <= span.last[0] {
            rest = &rest[rest.partition_point(|t| t.strips < [row, span.first[1]])..];
            let Some(&Tube { strips, .. }) = rest.first() else {
                return;
            };
            if strips[0] > row {
                row = strips[0];
                continue;
            }
            let in_row = rest.partition_point(|t| t.strips <= [row, span.last[1]]);
            for tube in &rest[..in_row] {
                self.look_up_in(tube, span, aabb, owner, emitter);
            }
            rest = &rest[in_row..];
            let Some(next) = row.checked_add(1) else {
                return;
            };
            row = next;
        }
    }

    #[inline(always)]
    fn look_up_in(
        &self,
        tube: &Tube,
        span: &TubeSpan,
        aabb: &Aabb<R, D>,
        owner: u32,
        emitter: &mut Emitter,
    ) {
        let owner = owner_in(tube.strips, span.first, owner);
        let maxs = &self.running_maxs[tube.start as usize..tube.end as usize];
        let start = tube.start as usize + maxs.partition_point(|&max| max < aabb.mins[0]);
        self.columns().window::<true>(start, aabb, owner, emitter);
    }
}
