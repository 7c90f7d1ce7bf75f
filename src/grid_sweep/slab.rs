//! A part of the tubes, for one thread.
//!
//! Tubes do not depend on each other, so any range of them can be filled, sorted and swept on its own. Each slab
//! goes through all boxes and takes those that span its tubes. That is a small part of the work, and it means that
//! nothing is shared. The pairs of the slabs, one after the other, are those that a single slab finds, in the same
//! order.

use std::ops::Range;

use super::grid::Grid;
use super::sweep::Emitter;
use super::tubes::Tubes;
use crate::tuning::kernel::SLAB_SAMPLE;
use crate::{Aabb, Real};

/// Some of the tubes of a grid, and the pairs found in them.
#[derive(Clone, Debug)]
pub(super) struct Slab<R, const D: usize> {
    pub(super) tubes: Tubes<R, D>,
    /// The numbers of the tubes in the grid.
    pub(super) range: Range<u32>,
    /// Scratch: the boxes too large for the grid, and the pairs.
    pub(super) outsize: Vec<u32>,
    pairs: Vec<[u32; 2]>,
}

impl<R: Real, const D: usize> Default for Slab<R, D> {
    fn default() -> Self {
        Self {
            tubes: Tubes::default(),
            range: 0..0,
            outsize: Vec::new(),
            pairs: Vec::new(),
        }
    }
}

impl<R: Real, const D: usize> Slab<R, D> {
    /// Finds the pairs and keeps them until they are [taken](Self::take_pairs).
    pub(super) fn sweep(&mut self) {
        let mut emitter = Emitter::new(&mut self.pairs);
        self.tubes.sweep(&mut emitter);
        emitter.finish();
    }

    /// Frees what only a run needs.
    #[cfg(feature = "_adapter")]
    pub(super) fn free_scratch(&mut self) {
        self.outsize = Vec::new();
        self.pairs = Vec::new();
        self.tubes.free_scratch();
    }

    /// Appends the pairs that were found.
    pub(super) fn take_pairs(&mut self, pairs: &mut Vec<[u32; 2]>) {
        pairs.append(&mut self.pairs);
    }
}

/// Cuts the tubes of a grid into at most `count` ranges that are about equally full.
pub(super) fn split<R: Real, const D: usize>(
    grid: &Grid<R>,
    boxes: &[Aabb<R, D>],
    members: &[u32],
    count: usize,
) -> Vec<Range<u32>> {
    let columns = grid.axes[1].last + 1;
    let end = grid.tube_count() as u32;
    let mut tubes: Vec<u32> = members
        .iter()
        .step_by(members.len() / SLAB_SAMPLE + 1)
        .map(|&member| {
            let [row, column] = grid.tube_span(&boxes[member as usize]).first;
            row * columns + column
        })
        .collect();
    tubes.sort_unstable();
    // More would be empty.
    let count = count.min(tubes.len());
    let mut start = 0;
    let mut ranges: Vec<_> = (1..count)
        .filter_map(|part| {
            let border = *tubes.get(part * tubes.len() / count)?;
            (border > start).then(|| std::mem::replace(&mut start, border)..border)
        })
        .collect();
    ranges.push(start..end);
    ranges
}
