//! A part of the tubes, for one thread.
//!
//! Tubes do not depend on each other, so any range of them can be sorted and swept on its own. The pairs of the slabs, one
//! after the other, are those that a single slab finds, in the same order.

use std::ops::Range;

use super::grid::Grid;
use super::owner::Owner;
use super::part::{Part, entries_before};
use super::scattered::Scattered;
use super::sweep::Emitter;
use super::tubes::{Entry, Tubes};
use crate::stopwatch::{Phase, Stopwatch};
use crate::{Aabb, Real};

/// Some of the tubes of a grid, and the pairs found in them.
#[derive(Clone, Debug)]
pub(super) struct Slab<R, const D: usize> {
    pub(super) tubes: Tubes<R, D>,
    /// Scratch: the entries of one tube, and the pairs.
    entries: Vec<Entry<R, D>>,
    pub(super) pairs: Vec<[u32; 2]>,
    pub(super) stopwatch: Stopwatch,
}

impl<R: Real, const D: usize> Default for Slab<R, D> {
    fn default() -> Self {
        Self {
            tubes: Tubes::default(),
            entries: Vec::new(),
            pairs: Vec::new(),
            stopwatch: Stopwatch::default(),
        }
    }
}

impl<R: Real, const D: usize> Slab<R, D> {
    /// Puts each tube of the range together from the parts, sorts and sweeps it while it is in the cache, and appends the pairs.
    /// Only if it `keeps` the tubes, boxes can be looked up in them later.
    pub(super) fn find(
        &mut self,
        boxes: &[Aabb<R, D>],
        grid: &Grid<R>,
        parts: &[Part],
        keeps: bool,
        pairs: &mut Vec<[u32; 2]>,
    ) {
        let range = self.tubes.range.clone();
        let size = keeps.then(|| {
            let is_occupied = |&tube: &u32| parts.iter().any(|part| !part.tube(tube).is_empty());
            let entries = entries_before(parts, range.end) - entries_before(parts, range.start);
            (entries, range.clone().filter(is_occupied).count())
        });
        let mut entries = std::mem::take(&mut self.entries);
        let mut pass = Pass::new(self, size, pairs);
        let columns = grid.axes[1].last + 1;
        for tube in range {
            entries.clear();
            if let [part] = parts {
                gather(boxes, part.tube(tube).iter().copied(), &mut entries);
            } else {
                gather_parts(boxes, parts, tube, &mut entries);
            }
            if keeps {
                pass.tubes.enter_in_table(!entries.is_empty());
            }
            if !entries.is_empty() {
                pass.take([tube / columns, tube % columns], &entries);
            }
        }
        pass.finish();
        self.entries = entries;
    }

    /// The same where there is no table of tubes.
    pub(super) fn find_scattered(
        &mut self,
        boxes: &[Aabb<R, D>],
        scattered: &Scattered,
        keeps: bool,
        pairs: &mut Vec<[u32; 2]>,
    ) {
        let size = keeps.then(|| (scattered.len(), scattered.tubes().count()));
        let mut entries = std::mem::take(&mut self.entries);
        let mut pass = Pass::new(self, size, pairs);
        for (strips, owners) in scattered.tubes() {
            entries.clear();
            gather(boxes, owners, &mut entries);
            pass.take(strips, &entries);
        }
        pass.finish();
        self.entries = entries;
    }

    /// Frees what only a run needs.
    #[cfg(feature = "_adapter")]
    pub(super) fn free_scratch(&mut self) {
        self.entries = Vec::new();
        self.pairs = Vec::new();
        self.tubes.free_scratch();
    }
}

/// A pass over the tubes of a slab, each of which is sorted and swept.
struct Pass<'a, R: Real, const D: usize> {
    tubes: &'a mut Tubes<R, D>,
    keeps: bool,
    emitter: Emitter<'a>,
    stopwatch: &'a mut Stopwatch,
}

impl<'a, R: Real, const D: usize> Pass<'a, R, D> {
    /// Begins with no tubes. If they are kept, how many entries in how many tubes are to come is known.
    fn new(
        slab: &'a mut Slab<R, D>,
        size: Option<(usize, usize)>,
        pairs: &'a mut Vec<[u32; 2]>,
    ) -> Self {
        let Slab {
            tubes, stopwatch, ..
        } = slab;
        stopwatch.enter(Phase::Sort);
        if let Some((entries, occupied)) = size {
            tubes.reserve(entries, occupied);
        }
        Self {
            tubes,
            keeps: size.is_some(),
            emitter: Emitter::new(pairs),
            stopwatch,
        }
    }

    /// Sorts and sweeps the next tube that has entries.
    fn take(&mut self, strips: [u32; 2], entries: &[Entry<R, D>]) {
        let sorted = self.tubes.push(strips, entries, self.keeps);
        self.stopwatch.enter(Phase::Sweep);
        self.tubes.columns().sweep(sorted, &mut self.emitter);
        self.stopwatch.enter(Phase::Sort);
    }

    fn finish(self) {
        self.stopwatch.enter(Phase::Sweep);
        self.emitter.finish();
        self.stopwatch.leave();
    }
}

/// Reads the boxes of some entries of a tube, which are anywhere in memory. They are copied before they are sorted, so that no read
/// waits for anything but the memory.
#[inline]
fn gather<R: Real, const D: usize>(
    boxes: &[Aabb<R, D>],
    owners: impl Iterator<Item = Owner>,
    entries: &mut Vec<Entry<R, D>>,
) {
    entries.extend(owners.map(|owner| Entry {
        aabb: boxes[owner.index() as usize],
        owner,
    }));
}

/// Puts the entries of a tube together in the order that they have in a single part.
fn gather_parts<R: Real, const D: usize>(
    boxes: &[Aabb<R, D>],
    parts: &[Part],
    tube: u32,
    entries: &mut Vec<Entry<R, D>>,
) {
    let tubes = parts.iter().map(|part| part.tube(tube));
    let halves = tubes.map(|tube| tube.split_at(tube.partition_point(|owner| owner.is_at_home())));
    for (homes, _) in halves.clone() {
        gather(boxes, homes.iter().copied(), entries);
    }
    for (_, ghosts) in halves {
        gather(boxes, ghosts.iter().copied(), entries);
    }
}

/// Cuts the tubes of a grid into at most `count` ranges that are about equally full.
pub(super) fn split<R: Real>(grid: &Grid<R>, parts: &[Part], count: usize) -> Vec<Range<u32>> {
    let end = grid.tube_count() as u32;
    let total = entries_before(parts, end);
    let mut ranges = Vec::with_capacity(count);
    let mut start = 0;
    for part in 1..count {
        let share = total * part / count;
        // The first tube that begins at or after the share.
        let (mut border, mut high) = (start, end);
        while border < high {
            let middle = border + (high - border) / 2;
            if entries_before(parts, middle) < share {
                border = middle + 1;
            } else {
                high = middle;
            }
        }
        if start < border && border < end {
            ranges.push(start..border);
            start = border;
        }
    }
    ranges.push(start..end);
    ranges
}
