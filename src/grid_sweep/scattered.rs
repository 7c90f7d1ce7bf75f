//! Boxes so far apart that a table of tubes would be mostly empty: dealt by sorting instead.

use super::ghosts::for_each_tube;
use super::grid::Grid;
use super::members::Members;
use super::owner::Owner;
use super::part::Entry;
use crate::endpoints::RadixSort;
use crate::{Aabb, Real};

/// Entries by tube, in the order of strips.
#[derive(Clone, Debug)]
pub(super) struct Scattered<R, const D: usize> {
    entries: Vec<Entry<R, D>>,
    /// Of each entry the tube, its row before its column, and the bits of the owner.
    keyed: Vec<(u64, u32)>,
    /// How many bits of a tube are its column.
    column_bits: u32,
}

impl<R, const D: usize> Default for Scattered<R, D> {
    fn default() -> Self {
        Self {
            entries: Vec::new(),
            keyed: Vec::new(),
            column_bits: 0,
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
        let Self { entries, keyed, .. } = self;
        keyed.clear();
        let mut columns = 0;
        members.for_each(boxes, 0..members.count(), |_, index, aabb| {
            let span = grid.tube_span(aabb);
            if span.is_outsize() {
                outsize.push(index);
            } else {
                columns |= span.last[1];
                for_each_tube(&span, index, |[row, column], owner| {
                    keyed.push((u64::from(row) << 32 | u64::from(column), owner.bits()));
                });
            }
        });
        // Without a gap between row and column there are fewer digits to sort by.
        self.column_bits = u32::BITS - columns.leading_zeros();
        for (tube, _) in &mut *keyed {
            let [row, column] = [*tube >> 32, *tube & u64::from(u32::MAX)];
            *tube = row << self.column_bits | column;
        }
        // Its memory is not kept: boxes are rarely scattered, and it is as much again as that of the entries.
        RadixSort::default().sort_entries(keyed);
        entries.clear();
        entries.extend(keyed.iter().map(|&(_, owner)| {
            let owner = Owner::from_bits(owner);
            let aabb = boxes[owner.index() as usize];
            Entry { aabb, owner }
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
            let row = key >> self.column_bits;
            (
                [row as u32, (key ^ row << self.column_bits) as u32],
                entries,
            )
        })
    }
}
