//! Boxes so far apart that a table of tubes would be mostly empty: assigned to tubes by sorting.

use super::grid::Grid;
use super::members::Members;
use super::owner::Owner;
use crate::aabb::Aabb;
use crate::radix_sort::RadixSort;
use crate::real::Real;

/// Entries by tube, in the order of strips.
#[derive(Clone, Debug, Default)]
pub(super) struct Scattered {
    /// Of each entry the tube, its row above its column, and the bits of the owner.
    entries: Vec<(u64, u32)>,
    /// How many bits of a tube are its column.
    column_bits: u32,
}

impl Scattered {
    /// Enters the members into all tubes that they span. Oversized ones are passed over and appended to `oversized`.
    pub(super) fn assign<R: Real, const D: usize>(
        &mut self,
        boxes: &[Aabb<R, D>],
        members: impl Members,
        grid: &Grid<R>,
        oversized: &mut Vec<u32>,
    ) {
        let mut unsorted = Vec::with_capacity(members.count());
        let mut columns = 0;
        members.for_each(boxes, 0..members.count(), |_, index, aabb| {
            let span = grid.tube_span(aabb);
            if span.is_oversized() {
                return oversized.push(index);
            }
            columns |= span.last[1];
            for row in span.first[0]..=span.last[0] {
                for column in span.first[1]..=span.last[1] {
                    let owner = Owner::of(index, [row, column], span.first);
                    unsorted.push(([row, column], owner));
                }
            }
        });
        // Without a gap between row and column there are fewer digits to sort by.
        let column_bits = u32::BITS - columns.leading_zeros();
        let keyed = unsorted.iter().map(|&([row, column], owner)| {
            let tube = u64::from(row) << column_bits | u64::from(column);
            (tube, owner.0)
        });
        self.column_bits = column_bits;
        // The memory of the sort is not kept: boxes are rarely scattered, and it is twice as much again.
        RadixSort::default().sort(keyed, |entry| entry, &mut self.entries);
    }

    /// The number of entries.
    pub(super) fn len(&self) -> usize {
        self.entries.len()
    }

    /// The tubes that have entries: their strips, and whose the entries are.
    pub(super) fn tubes(&self) -> impl Iterator<Item = ([u32; 2], impl Iterator<Item = Owner>)> {
        self.entries.chunk_by(|a, b| a.0 == b.0).map(|entries| {
            let tube = entries[0].0;
            let row = tube >> self.column_bits;
            let strips = [row as u32, (tube ^ row << self.column_bits) as u32];
            (strips, entries.iter().map(|&(_, owner)| Owner(owner)))
        })
    }
}
