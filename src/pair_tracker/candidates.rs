//! The candidates: pairs of proxies whose fat boxes overlap.
//!
//! When most proxies were touched, all candidates are compared, in order; when few were, their candidates are picked by a bit
//! for each slot; when very few were, by lists. The lists are made once they would have been useful a number of times, and
//! kept up to date until all candidates are replaced.

mod array;
mod lists;
mod proxies;
mod retired;
mod state;

use super::policy::{self, Extent};
use super::{FilterKey, PairChange};
use crate::bit_set::BitSet;
use crate::slot_set::SlotSet;
use crate::{Aabb, Real, Work};
use array::CandidateArray;
use lists::CandidateLists;
pub(super) use lists::ListState;
pub(super) use proxies::Proxies;

/// The candidates, and the lists through them.
#[derive(Clone, Debug, Default)]
pub(super) struct Candidates {
    array: CandidateArray,
    lists: CandidateLists,
    /// Scratch: the slots whose candidates are picked, and those candidates.
    slots: BitSet,
    rows: BitSet,
}

impl Candidates {
    /// The held pairs.
    pub(super) fn held(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.array.held()
    }

    /// Calls `visit` with each candidate of one of these slots whose boxes overlap, and that is not held. There are `count` slots in
    /// all.
    pub(super) fn near_of(&mut self, of: &[u32], count: usize, visit: impl FnMut([u32; 2])) {
        let Self { array, slots, .. } = self;
        slots.resize(count);
        for &slot in of {
            slots.insert(slot as usize);
        }
        let is_one = slots.lookup();
        let near = array.near().map(|(_, pair)| pair);
        near.filter(|pair| pair.iter().any(|&slot| is_one(slot as usize)))
            .for_each(visit);
        drop(is_one);
        slots.clear_around(of);
    }

    /// The candidates whose boxes overlap, and that are not held.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn near(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.array.near().map(|(_, pair)| pair)
    }

    /// The candidates that were `found` for boxes that are as large as their fat boxes, of which those in `near` are not held.
    ///
    /// # Errors
    /// If a pair in `near` was not found.
    #[cfg(feature = "serde-serialize")]
    pub(super) fn restored(
        found: Vec<[u32; 2]>,
        near: Vec<[u32; 2]>,
    ) -> Result<Self, &'static str> {
        Ok(Self {
            array: CandidateArray::overlapping(found, near)?,
            ..Self::default()
        })
    }

    pub(super) fn held_count(&self) -> usize {
        self.array.held_count()
    }

    /// How many candidates overlap, held or not.
    pub(super) fn overlapping_count(&self) -> usize {
        self.array.overlapping_count()
    }

    /// All candidates, held or not.
    pub(super) fn iter(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.array.iter()
    }

    pub(super) fn len(&self) -> usize {
        self.array.len()
    }

    /// The rows of the array, tombstones included.
    pub(super) fn rows(&self) -> usize {
        self.array.rows()
    }

    /// Whether there are lists, or how often they were missed.
    pub(super) fn lists(&self) -> ListState {
        self.lists.state()
    }

    /// Makes `found` the candidates, and leaves the memory of the former ones there.
    pub(super) fn replace<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        found: &mut Vec<[u32; 2]>,
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        self.lists.forget();
        self.array.replace(found, proxies, report);
    }

    /// Adds candidates.
    pub(super) fn extend<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        found: &[[u32; 2]],
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        let first = self.array.rows();
        self.array.extend(found, proxies, report);
        self.lists.extend(&self.array, first, proxies.now.len());
    }

    /// Brings the candidates of the `touched` up to date with the present boxes, and retires those of the `escaped`, which
    /// must be among the `touched`. Looks at all candidates, or at those of the `touched` only. Returns what it took.
    ///
    /// Picking a few candidates out of all is cheap, and walking lists is not: it waits for memory at each step. So lists are
    /// for very few.
    pub(super) fn compare<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        extent: Extent,
        touched: &[u32],
        escaped: &SlotSet,
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) -> Work {
        let mut work = Work::default();
        match extent {
            Extent::All => {
                self.compare_all(escaped, proxies, report);
                work.compared = self.rows();
            }
            Extent::Picked { lists_are_missed } => {
                work.picked = self.rows();
                work.compared = self.compare_picked(escaped, touched, proxies, report);
                if lists_are_missed {
                    self.lists.miss();
                }
            }
            Extent::Listed => {
                if !self.lists.state().are_made {
                    self.compact();
                    self.lists.make(&self.array, proxies.now.len());
                }
                self.compare_listed(touched, escaped, proxies, report);
                work.walked = touched.len();
            }
        }
        work
    }

    /// Brings the candidates of the `stirred`, of which no box was renewed, up to date with the present volumes.
    pub(super) fn compare_stirred<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        stirred: &[u32],
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        let Self {
            array,
            lists,
            slots,
            rows,
        } = self;
        if lists.state().are_made && policy::is_walking_cheaper(stirred.len(), array.rows()) {
            for &slot in stirred {
                lists.walk(slot, |row| {
                    array.compare(row, proxies, report);
                    array.get(row).is_some()
                });
            }
            return;
        }
        slots.resize(proxies.now.len());
        for &slot in stirred {
            slots.insert(slot as usize);
        }
        let is_stirred = slots.lookup();
        let has_stirred = |[a, b]: [u32; 2]| is_stirred(a as usize) | is_stirred(b as usize);
        array.compare_near(rows, has_stirred, proxies, report);
        drop(is_stirred);
        slots.clear_around(stirred);
    }

    fn compare_all<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        escaped: &SlotSet,
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        let Self { array, rows, .. } = self;
        let mut is_changed = array.compact();
        is_changed |= array.compare_all(rows, escaped, proxies, report);
        if is_changed {
            self.lists.forget();
        }
    }

    /// Returns how many were picked.
    fn compare_picked<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        escaped: &SlotSet,
        touched: &[u32],
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) -> usize {
        let Self {
            array, slots, rows, ..
        } = self;
        slots.resize(proxies.now.len());
        for &slot in touched {
            slots.insert(slot as usize);
        }
        let is_touched = slots.lookup();
        array.pick(rows, |slot| is_touched(slot as usize));
        drop(is_touched);
        let mut count = 0;
        for row in rows.iter() {
            count += 1;
            if array
                .get(row)
                .is_some_and(|pair| pair.iter().any(|&slot| escaped.contains(slot)))
            {
                array.retire(row, proxies, report);
            } else {
                array.compare(row, proxies, report);
            }
        }
        slots.clear_around(touched);
        count
    }

    fn compare_listed<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        touched: &[u32],
        escaped: &SlotSet,
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        let Self { array, lists, .. } = self;
        for &slot in escaped.slots() {
            lists.take(slot, |row| array.retire(row, proxies, report));
        }
        for &slot in touched {
            lists.walk(slot, |row| {
                array.compare(row, proxies, report);
                array.get(row).is_some()
            });
        }
    }

    /// Removes the tombstones if they are more than half of all rows.
    pub(super) fn compact_if_sparse(&mut self) {
        if self.array.is_sparse() {
            self.compact();
        }
    }

    fn compact(&mut self) {
        if self.array.compact() {
            // Rows have moved.
            self.lists.forget();
        }
    }

    /// Panics unless flags, counts and, if they are made, lists are consistent.
    ///
    /// `volumes_meet` tells whether a pair whose boxes overlap, and that is held or not, should be.
    pub(super) fn validate<R: Real, const D: usize>(
        &self,
        now: &[Aabb<R, D>],
        volumes_meet: impl Fn([u32; 2], bool) -> bool,
    ) {
        self.array.validate(now, volumes_meet);
        self.lists.validate(&self.array);
    }

    /// How many tombstones there are.
    #[cfg(test)]
    pub(super) fn tombstones(&self) -> usize {
        self.array.rows() - self.array.len()
    }
}
