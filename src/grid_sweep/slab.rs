//! A part of the tubes, sorted and swept by one thread.
//!
//! Tubes do not depend on each other, so any range of them can be sorted and swept on its own. The pairs of the slabs, one
//! after the other, are those that a single slab finds, in the same order.

use super::assignment::Assignment;
use super::crowd::Crowd;
use super::emitter::{Emitter, Tally};
use super::order::Order;
use super::owner::Owner;
use super::part::Part;
use super::tubes::{Entry, Tubes};
use crate::aabb::Aabb;
use crate::real::Real;
use crate::stopwatch::{Phase, Stopwatch};
use crate::tuning::kernel::COMPARED_AN_ENTRY;

/// Some of the tubes of a grid, and the pairs found in them.
#[derive(Clone, Debug, Default)]
pub(super) struct Slab<R, const D: usize> {
    pub(super) tubes: Tubes<R, D>,
    /// Scratch: the entries of one tube, and the pairs.
    entries: Vec<Entry<R, D>>,
    pub(super) pairs: Vec<[u32; 2]>,
    pub(super) tally: Tally,
    pub(super) stopwatch: Stopwatch,
}

impl<R: Real, const D: usize> Slab<R, D> {
    /// Puts each tube of the range together, sorts and sweeps it while it is in the cache, and appends the pairs to `self.pairs`.
    /// Only if tubes are kept, boxes can be looked up in them later.
    ///
    /// A tube whose entries crowd is searched by a kernel of its own, if they may crowd. Stops when there are more than `most` pairs.
    pub(super) fn sweep(
        &mut self,
        boxes: &[Aabb<R, D>],
        assignment: &Assignment,
        may_crowd: bool,
        keeps: bool,
        most: usize,
    ) {
        let (tubes, entries, stopwatch) = (&mut self.tubes, &mut self.entries, &mut self.stopwatch);
        let range = tubes.range.clone();
        stopwatch.enter(Phase::Sort);
        if keeps {
            let [start, end] = [range.start, range.end].map(|tube| assignment.entries_before(tube));
            let occupied = range.clone().filter(|&tube| assignment.is_occupied(tube));
            tubes.reserve(end - start, occupied.count());
        }
        let mut emitter = Emitter::new(&mut self.pairs, most);
        for tube in range {
            entries.clear();
            gather_parts(boxes, &assignment.parts, tube, entries);
            if entries.is_empty() {
                continue;
            }
            let sorted = tubes.push(tube, entries, keeps);
            stopwatch.enter(Phase::Sweep);
            let most_compared = match may_crowd {
                true => COMPARED_AN_ENTRY * entries.len(),
                false => usize::MAX,
            };
            let first_pair = emitter.count();
            let is_swept = tubes.columns().sweep(sorted, most_compared, &mut emitter);
            if emitter.is_over() {
                break;
            }
            if !is_swept {
                emitter.take_back(first_pair);
                let crowd = Crowd::search(entries, keeps, &mut emitter);
                if keeps {
                    tubes.crowds.push((tube, crowd));
                }
            }
            stopwatch.enter(Phase::Sort);
        }
        stopwatch.enter(Phase::Sweep);
        self.tally = emitter.finish();
        stopwatch.leave();
    }

    /// Frees what only a run needs.
    pub(super) fn free_scratch(&mut self) {
        self.entries = Vec::new();
        self.pairs = Vec::new();
        self.tubes.order = Order::default();
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
    parts: &[Part],
    tube: u32,
    entries: &mut Vec<Entry<R, D>>,
) {
    if let [part] = parts {
        return gather(boxes, part.tube(tube).iter().copied(), entries);
    }
    let tubes = parts.iter().map(|part| part.tube(tube));
    let halves = tubes.map(|tube| tube.split_at(tube.partition_point(|owner| owner.is_at_home())));
    for (homes, _) in halves.clone() {
        gather(boxes, homes.iter().copied(), entries);
    }
    for (_, ghosts) in halves {
        gather(boxes, ghosts.iter().copied(), entries);
    }
}
