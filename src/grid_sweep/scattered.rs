//! Boxes so far apart that a table of tubes would be mostly empty: dealt by sorting instead.

use super::ghosts::for_each_tube;
use super::grid::Grid;
use super::members::Members;
use super::owner::Owner;
use crate::endpoints::RadixSort;
use crate::{Aabb, Real};

/// Entries by tube, in the order of strips.
#[derive(Clone, Debug, Default)]
pub(super) struct Scattered {
    /// Of each entry the tube, its row before its column, and the bits of the owner.
    keyed: Vec<(u64, u32)>,
    /// How many bits of a tube are its column.
    column_bits: u32,
}

impl Scattered {
    /// Enters the members into all tubes that they span. Outsize ones are passed over and appended to `outsize`.
    pub(super) fn deal<R: Real, const D: usize>(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: impl Members,
        grid: &Grid<R>,
        outsize: &mut Vec<u32>,
    ) {
        let keyed = &mut self.keyed;
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
        // The memory of the sort is not kept: boxes are rarely scattered, and it is as much again.
        RadixSort::default().sort_entries(keyed);
    }

    /// The number of entries.
    pub(super) fn len(&self) -> usize {
        self.keyed.len()
    }

    /// The tubes that have entries: their strips, and whose the entries are.
    pub(super) fn tubes(&self) -> impl Iterator<Item = ([u32; 2], impl Iterator<Item = Owner>)> {
        self.keyed.chunk_by(|a, b| a.0 == b.0).map(|tube| {
            let key = tube[0].0;
            let row = key >> self.column_bits;
            let strips = [row as u32, (key ^ row << self.column_bits) as u32];
            let owners = tube.iter().map(|&(_, owner)| Owner::from_bits(owner));
            (strips, owners)
        })
    }
}
