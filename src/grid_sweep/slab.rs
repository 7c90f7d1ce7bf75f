//! A part of the tubes, sorted and swept by one thread.
//!
//! Tubes do not depend on each other, so any range of them can be sorted and swept on its own. The pairs of the slabs, one
//! after the other, are those that a single slab finds, in the same order.

use super::emitter::Emitter;
use super::owner::Owner;
use super::part::Parts;
use super::scattered::Scattered;
use super::tubes::{Entry, Tubes};
use crate::aabb::Aabb;
use crate::real::Real;
use crate::stopwatch::{Phase, Stopwatch};

/// Some of the tubes of a grid, and the pairs found in them.
#[derive(Clone, Debug, Default)]
pub(super) struct Slab<R, const D: usize> {
    pub(super) tubes: Tubes<R, D>,
    /// Scratch: the entries of one tube, and the pairs.
    entries: Vec<Entry<R, D>>,
    pub(super) pairs: Vec<[u32; 2]>,
    pub(super) stopwatch: Stopwatch,
}

/// How much there is in a slab.
struct Size {
    entries: usize,
    /// Tubes that have entries.
    occupied: usize,
}

impl<R: Real, const D: usize> Slab<R, D> {
    /// Puts each tube of the range together from the parts, sorts and sweeps it, and appends the pairs. Only if tubes are kept,
    /// boxes can be looked up in them later.
    pub(super) fn sweep_parts(
        &mut self,
        boxes: &[Aabb<R, D>],
        parts: Parts,
        keeps: bool,
        pairs: &mut Vec<[u32; 2]>,
    ) {
        let range = self.tubes.range.clone();
        let size = keeps.then(|| Size {
            entries: parts.entries_before(range.end) - parts.entries_before(range.start),
            occupied: range.clone().filter(|&i| parts.is_occupied(i)).count(),
        });
        let tubes = range.map(|tube| {
            let gather = move |entries: &mut Vec<_>| gather_parts(boxes, parts, tube, entries);
            ([tube / parts.columns, tube % parts.columns], gather)
        });
        self.sweep(tubes, size, pairs);
    }

    /// The same where there is no table of tubes.
    pub(super) fn sweep_scattered(
        &mut self,
        boxes: &[Aabb<R, D>],
        scattered: &Scattered,
        keeps: bool,
        pairs: &mut Vec<[u32; 2]>,
    ) {
        let size = keeps.then(|| Size {
            entries: scattered.len(),
            occupied: scattered.tubes().count(),
        });
        let tubes = scattered.tubes().map(|(strips, owners)| {
            let gather = move |entries: &mut Vec<_>| gather(boxes, owners, entries);
            (strips, gather)
        });
        self.sweep(tubes, size, pairs);
    }

    /// Sorts and sweeps tubes, each of which is given by its strips and by what gathers its entries, while it is in the cache.
    /// They are kept if their size is given.
    fn sweep(
        &mut self,
        tubes: impl Iterator<Item = ([u32; 2], impl FnOnce(&mut Vec<Entry<R, D>>))>,
        size: Option<Size>,
        pairs: &mut Vec<[u32; 2]>,
    ) {
        let (kept, entries, stopwatch) = (&mut self.tubes, &mut self.entries, &mut self.stopwatch);
        stopwatch.enter(Phase::Sort);
        let keeps = size.is_some();
        if let Some(Size { entries, occupied }) = size {
            kept.reserve(entries, occupied);
        }
        let mut emitter = Emitter::new(pairs);
        for (strips, gather) in tubes {
            entries.clear();
            gather(entries);
            if entries.is_empty() {
                continue;
            }
            let sorted = kept.push(strips, entries, keeps);
            stopwatch.enter(Phase::Sweep);
            kept.columns().sweep(sorted, &mut emitter);
            stopwatch.enter(Phase::Sort);
        }
        stopwatch.enter(Phase::Sweep);
        emitter.finish();
        stopwatch.leave();
    }

    /// Frees what only a run needs.
    pub(super) fn free_scratch(&mut self) {
        self.entries = Vec::new();
        self.pairs = Vec::new();
        self.tubes.free_scratch();
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
#[inline]
fn gather_parts<R: Real, const D: usize>(
    boxes: &[Aabb<R, D>],
    parts: Parts,
    tube: u32,
    entries: &mut Vec<Entry<R, D>>,
) {
    if let [part] = parts.parts {
        return gather(boxes, part.tube(tube).iter().copied(), entries);
    }
    let tubes = parts.parts.iter().map(|part| part.tube(tube));
    let halves = tubes.map(|tube| tube.split_at(tube.partition_point(|owner| owner.is_at_home())));
    for (homes, _) in halves.clone() {
        gather(boxes, homes.iter().copied(), entries);
    }
    for (_, ghosts) in halves {
        gather(boxes, ghosts.iter().copied(), entries);
    }
}
