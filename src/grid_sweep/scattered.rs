//! Boxes so far apart that a table of tubes would be mostly empty: dealt by sorting instead.

use super::ghosts::for_each_tube;
use super::grid::Grid;
use super::members::Members;
use super::owner::Owner;
use super::part::Entry;
use crate::{Aabb, Real};

/// Entries by tube, in the order of strips.
#[derive(Clone, Debug)]
pub(super) struct Scattered<R, const D: usize> {
    entries: Vec<Entry<R, D>>,
    /// The tube, the index of the box, and the owner of each entry.
    keyed: Vec<(u64, u32, Owner)>,
}

impl<R, const D: usize> Default for Scattered<R, D> {
    fn default() -> Self {
        Self {
            entries: Vec::new(),
            keyed: Vec::new(),
        }
    }
}

impl<R: Real, const D: usize> Scattered<R, D> {
    /// Enters the members into all tubes that they span. Outsize ones are passed over and appended to `outsize`.
    pub(super) fn deal(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: impl Members,
        grid: &Grid<R>,
        outsize: &mut Vec<u32>,
    ) {
        let Self { entries, keyed } = self;
        keyed.clear();
        members.for_each(boxes, 0..members.count(), |_, index, aabb| {
            let span = grid.tube_span(aabb);
            if span.is_outsize() {
                outsize.push(index);
            } else {
                for_each_tube(&span, index, |[row, column], owner| {
                    keyed.push((u64::from(row) << 32 | u64::from(column), index, owner));
                });
            }
        });
        keyed.sort_unstable_by_key(|&(tube, index, _)| (tube, index));
        entries.clear();
        entries.extend(keyed.iter().map(|&(_, index, owner)| Entry {
            aabb: boxes[index as usize],
            owner,
        }));
    }

    /// The number of entries.
    pub(super) fn len(&self) -> usize {
        self.entries.len()
    }

    /// The tubes that have entries: their strips, and the entries.
    pub(super) fn tubes(&self) -> impl Iterator<Item = ([u32; 2], &[Entry<R, D>])> {
        let mut start = 0;
        self.keyed.chunk_by(|a, b| a.0 == b.0).map(move |tube| {
            let key = tube[0].0;
            let entries = &self.entries[start..start + tube.len()];
            start += tube.len();
            ([(key >> 32) as u32, key as u32], entries)
        })
    }
}
