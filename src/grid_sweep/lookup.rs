//! One box against boxes that are already sorted.
//!
//! This is how boxes much larger than the rest meet the rest: a box that spans more than two strips on an
//! axis gets no entries, because there could be any number of them. And it is how a few boxes that have
//! moved meet the many that have not.
//!
//! Entries are sorted by `mins[0]`, and the running maximum of `maxs[0]` ascends too. So in each occupied
//! tube that the box spans, a binary search finds the first entry to look at, for boxes of any sizes.

use super::emitter::Emitter;
use super::grid::TubeSpan;
use super::owner::Owner;
use super::tubes::{NOWHERE, Tube, Tubes};
use crate::aabb::Aabb;
use crate::real::Real;
use crate::tuning::kernel::TABLE_LOOKUPS_UP_TO;

/// A box that is looked up.
pub(super) struct Query<'a, R, const D: usize> {
    pub(super) aabb: &'a Aabb<R, D>,
    pub(super) index: u32,
    /// The tubes that it spans.
    pub(super) span: TubeSpan,
}

impl<R: Real, const D: usize> Tubes<R, D> {
    /// Whether [`look_up`](Self::look_up) may be called.
    pub(super) fn is_prepared(&self) -> bool {
        self.running_maxs.len() == self.owners.len()
    }

    /// Prepares for [`look_up`](Self::look_up), until the next run, if it is not prepared.
    pub(super) fn prepare_lookup(&mut self) {
        if self.row_length > 0 {
            self.table.resize(self.range.len(), NOWHERE);
        }
        self.running_maxs.extend_from_slice(&self.maxs[0]);
        for (position, tube) in (0..).zip(&self.tubes) {
            if !self.table.is_empty() {
                let [row, column] = tube.strips;
                self.table[(row * self.row_length + column - self.range.start) as usize] = position;
            }
            let mut running = R::NEG_INFINITY;
            for max in &mut self.running_maxs[tube.start as usize..tube.end as usize] {
                running = if *max > running { *max } else { running };
                *max = running;
            }
        }
    }

    /// Reports every box that overlaps a given one, once, however many entries it has.
    pub(super) fn look_up(&self, query: &Query<R, D>, emitter: &mut Emitter) {
        let TubeSpan { first, last } = query.span;
        let tubes = [0, 1].map(|cut| u64::from(last[cut] - first[cut]) + 1);
        if self.table.is_empty() || tubes[0] * tubes[1] > TABLE_LOOKUPS_UP_TO {
            return self.search(query, emitter);
        }
        for row in first[0]..=last[0] {
            for column in first[1]..=last[1] {
                let tube = (row * self.row_length + column).wrapping_sub(self.range.start) as usize;
                // Tubes of another slab are beyond the end.
                let position = self.table.get(tube).copied().unwrap_or(NOWHERE);
                if let Some(tube) = self.tubes.get(position as usize) {
                    self.look_up_in(tube, query, emitter);
                }
            }
        }
    }

    /// The same for a box that may span any number of tubes, few of which need be occupied.
    fn search(&self, query: &Query<R, D>, emitter: &mut Emitter) {
        let TubeSpan { first, last } = query.span;
        let mut rest = &self.tubes[..];
        let mut row = first[0];
        // Each row that has tubes, and in it the tubes between the columns.
        while row <= last[0] {
            rest = &rest[rest.partition_point(|tube| tube.strips < [row, first[1]])..];
            let Some(&Tube { strips, .. }) = rest.first() else {
                return;
            };
            if strips[0] > row {
                row = strips[0];
                continue;
            }
            let in_row = rest.partition_point(|tube| tube.strips <= [row, last[1]]);
            for tube in &rest[..in_row] {
                self.look_up_in(tube, query, emitter);
            }
            rest = &rest[in_row..];
            // The greatest strip is 2^31.
            row += 1;
        }
    }

    #[inline(always)]
    fn look_up_in(&self, tube: &Tube, query: &Query<R, D>, emitter: &mut Emitter) {
        let Query { aabb, index, span } = query;
        let owner = Owner::of(*index, tube.strips, span.first);
        let maxs = &self.running_maxs[tube.start as usize..tube.end as usize];
        let start = tube.start as usize + maxs.partition_point(|&max| max < aabb.mins[0]);
        self.columns().window::<true>(start, aabb, owner, emitter);
    }
}
