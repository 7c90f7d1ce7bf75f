//! The sweep compares sorted entries with those that follow, eight at a time; a window compares one box with them. Processors
//! without vectors take one entry after the other. They find the same pairs in another order.

use std::ops::Range;

use super::entry::Owner;
use super::slab::Slab;
use super::worker::Worker;
use crate::aabb::Aabb;
use crate::bit_set::ones;
use crate::lanes::{ARE_VECTORS, LANES, Lanes};
use crate::real::Real;

/// The most blocks of eight candidates that eight entries share; entries with more go on alone.
const BLOCKS: usize = 4;

/// The arrays of the entries, of one length, so that one bounds check covers all of them.
#[derive(Clone, Copy)]
pub(super) struct Columns<'a, R, const D: usize> {
    mins: [&'a [R]; D],
    maxs: [&'a [R]; D],
    pub(super) owners: &'a [Owner],
}

impl<R: Real, const D: usize> Slab<R, D> {
    #[inline(always)]
    pub(super) fn columns(&self) -> Columns<'_, R, D> {
        let n = self.owners.len();
        Columns {
            mins: core::array::from_fn(|k| &self.mins[k][..n]),
            maxs: core::array::from_fn(|k| &self.maxs[k][..n]),
            owners: &self.owners[..n],
        }
    }
}

impl<R: Real, const D: usize> Columns<'_, R, D> {
    /// Reports every overlapping pair among the entries of a tube, except those of two ghosts on the same axis, which another tube
    /// reports. Gives up and returns false once the budget is exceeded.
    ///
    /// With vectors, compares eight entries at a time with those that follow them: all eight with the next, then all with the one after it,
    /// until none of the eight reaches that far along the first axis.
    pub(super) fn sweep(self, tube: Range<usize>, worker: &mut Worker) -> bool {
        for first in tube.clone().step_by(LANES) {
            let eight = Aabb {
                mins: core::array::from_fn(|k| load::<R>(self.mins[k], first)),
                maxs: core::array::from_fn(|k| load::<R>(self.maxs[k], first)),
            };
            // The lanes of the entries that still reach those they are compared with.
            let mut alive = (1_u32 << (tube.end - first).min(LANES)) - 1;
            let mut next = first + 1;
            while ARE_VECTORS && alive != 0 && next <= first + BLOCKS * LANES {
                let hits = self.compare(&eight, next, &mut alive);
                let these: &[Owner; LANES] = many(self.owners, first);
                let others: &[Owner; 2 * LANES] = many(self.owners, next);
                worker.emit(hits, |hit| {
                    let (lane, distance) = (hit % LANES, hit / LANES % LANES);
                    [these[lane], others[lane + distance]]
                });
                next += LANES;
            }
            worker.tally.compared += ((next - first - 1) * LANES) as u64;
            for lane in ones(alive.into()) {
                self.follow(first + lane, next + lane, worker);
            }
            if worker.is_budget_exceeded() {
                return false;
            }
        }
        true
    }

    /// Compares eight entries, each in its lane, with those from `next` on. The result has a byte for each distance, with a bit for each lane.
    #[inline(always)]
    fn compare(self, these: &Aabb<R::Lanes, D>, next: usize, alive: &mut u32) -> u64 {
        // Arrays need their bounds checked here only.
        let mins: [&[R; 2 * LANES]; D] = self.mins.map(|column| many(column, next));
        let maxs: [&[R; 2 * LANES]; D] = self.maxs.map(|column| many(column, next));
        let mut hits = 0;
        for shift in 0..LANES {
            let reached = load::<R>(mins[0], shift).le(these.maxs[0]);
            let mut overlap = reached;
            for k in 1..D {
                overlap = overlap
                    & load::<R>(mins[k], shift).le(these.maxs[k])
                    & load::<R>(maxs[k], shift).ge(these.mins[k]);
            }
            *alive &= reached.bits();
            hits |= u64::from(overlap.bits() & *alive) << (shift * LANES);
            if *alive == 0 {
                break;
            }
        }
        hits
    }

    /// Reports the pairs of an entry with those from `start` on.
    #[inline(never)]
    fn follow(self, i: usize, start: usize, worker: &mut Worker) {
        let (window, owner) = (start..self.owners.len(), self.owners[i]);
        let (compared, _) = self.window::<false>(window, &self.entry(i), |j, hits| {
            let others: &[Owner; LANES] = many(self.owners, j);
            worker.emit(hits, |lane| [owner, others[lane % LANES]]);
        });
        worker.tally.compared += compared as u64;
    }

    /// The box of an entry.
    #[inline(always)]
    pub(super) fn entry(self, i: usize) -> Aabb<R, D> {
        Aabb {
            mins: self.mins.map(|column| column[i]),
            maxs: self.maxs.map(|column| column[i]),
        }
    }

    /// Compares a box with the entries of a range, up to the first whose `mins[0]` lies beyond it. Returns how many were compared, and
    /// whether there is such an entry.
    ///
    /// Calls `visit` with the position of an entry and with a bit for it and each of the seven that follow, which is set if they
    /// overlap. Without `BOTH_SIDES`, all entries must reach the box along the first axis. With vectors, it visits eight entries at a time, also
    /// some past the range.
    #[inline(always)]
    pub(super) fn window<const BOTH_SIDES: bool>(
        self,
        range: Range<usize>,
        aabb: &Aabb<R, D>,
        mut visit: impl FnMut(usize, u64),
    ) -> (usize, bool) {
        if !ARE_VECTORS {
            return self.window_singly::<BOTH_SIDES>(range, aabb, visit);
        }
        let mins = aabb.mins.map(R::Lanes::splat);
        let maxs = aabb.maxs.map(R::Lanes::splat);
        let mut j = range.start;
        // The padding after the last sentinel is long enough.
        let end = range.end.min((self.owners.len() + 1).saturating_sub(LANES));
        while j < end {
            let reached = load::<R>(self.mins[0], j).le(maxs[0]);
            let mut overlap = reached;
            if BOTH_SIDES {
                overlap = overlap & load::<R>(self.maxs[0], j).ge(mins[0]);
            }
            for k in 1..D {
                overlap = overlap
                    & load::<R>(self.mins[k], j).le(maxs[k])
                    & load::<R>(self.maxs[k], j).ge(mins[k]);
            }
            let reached = reached.bits();
            // The lanes before the first that is not reached.
            let in_window = (reached ^ (reached + 1)) >> 1;
            visit(j, u64::from(overlap.bits() & in_window));
            j += LANES;
            if reached != (1 << LANES) - 1 {
                return (j - range.start, true);
            }
        }
        (j - range.start, false)
    }

    /// A window that visits each overlapping entry alone.
    #[inline(always)]
    fn window_singly<const BOTH_SIDES: bool>(
        self,
        range: Range<usize>,
        aabb: &Aabb<R, D>,
        mut visit: impl FnMut(usize, u64),
    ) -> (usize, bool) {
        let Aabb { mins, maxs } = aabb;
        let (start, count) = (range.start, range.len());
        for j in range {
            // False at the sentinel.
            let is_reached = self.mins[0][j] <= maxs[0];
            if !is_reached {
                return (j - start, true);
            }
            let mut overlaps = !BOTH_SIDES || self.maxs[0][j] >= mins[0];
            for k in 1..D {
                overlaps &= (self.mins[k][j] <= maxs[k]) & (self.maxs[k][j] >= mins[k]);
            }
            if overlaps {
                visit(j, 1);
            }
        }
        (count, false)
    }
}

/// The eight numbers from `start` on.
#[inline(always)]
fn load<R: Real>(numbers: &[R], start: usize) -> R::Lanes {
    R::Lanes::load(many(numbers, start))
}

/// `N` items from `start` on.
#[inline(always)]
pub(super) fn many<T, const N: usize>(items: &[T], start: usize) -> &[T; N] {
    items[start..]
        .first_chunk()
        .expect("the columns are padded")
}

#[cfg(test)]
mod tests {
    use super::super::entry::Entry;
    use super::*;

    #[test]
    fn entries_are_swept_alike_by_eights_and_singly() {
        let mut generator = oorandom::Rand64::new(1);
        let mut random = |below: u64| generator.rand_range(0..below);
        for round in 0..300 {
            // From few candidates per box to more than the blocks hold.
            let (count, width) = (1 + random(200), 1 + random(1 << (round % 8)));
            let mut entry = |i: u64| {
                let mins = [random(100), random(3), random(3)].map(|x| x as f32);
                let extents = [random(width), random(2), random(2)].map(|x| x as f32);
                let maxs = core::array::from_fn(|k| mins[k] + extents[k]);
                Entry {
                    aabb: Aabb::new(mins, maxs),
                    owner: Owner(i as u32 | (random(4) as u32) << 30),
                }
            };
            let entries: Vec<_> = (0..count).map(&mut entry).collect();
            let mut slab = Slab::<f32, 3>::default();
            let tube = slab.sort(&entries);
            let columns = slab.columns();
            let [mut by_eights, mut singly] = [Vec::new(), Vec::new()];
            let mut worker = Worker::new(&mut by_eights, usize::MAX);
            assert!(columns.sweep(tube.clone(), &mut worker));
            worker.finish();
            let mut worker = Worker::new(&mut singly, usize::MAX);
            for i in tube.clone() {
                let window = i + 1..columns.owners.len();
                columns.window_singly::<false>(window, &columns.entry(i), |j, hits| {
                    worker.emit(hits, |_| [columns.owners[i], columns.owners[j]]);
                });
            }
            worker.finish();
            by_eights.sort_unstable();
            singly.sort_unstable();
            assert_eq!(by_eights, singly);
            let Entry { aabb, .. } = entry(count);
            let [mut by_eights, mut singly] = [Vec::new(), Vec::new()];
            let window = tube.start..columns.owners.len();
            columns.window::<true>(window.clone(), &aabb, |j, hits| {
                by_eights.extend((0..LANES).filter(|i| hits >> i & 1 == 1).map(|i| j + i));
            });
            columns.window_singly::<true>(window, &aabb, |j, _| singly.push(j));
            assert_eq!(by_eights, singly);
        }
    }
}
