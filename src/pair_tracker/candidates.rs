//! The candidates: pairs of proxies whose fat boxes overlap.
//!
//! When most proxies were touched, all candidates are compared, in order; when few were, their candidates are picked by a bit
//! for each slot; when very few were, by lists. The lists are made once they would have been useful a number of times, and
//! kept up to date until all candidates are replaced.

mod array;
mod comparing;
mod lists;
mod pair_rules;
mod retired;
mod state;

use super::policy::{self, CompareMode};
use super::proxies::Proxies;
use super::{FilterKey, PairChange};
use crate::aabb::Aabb;
use crate::bit_set::BitSet;
use crate::real::Real;
use crate::stats::Work;
use array::CandidateArray;
use comparing::Comparing;
use lists::CandidateLists;

/// The candidates, and the lists through them.
#[derive(Clone, Debug, Default)]
pub(super) struct Candidates {
    pub(super) array: CandidateArray,
    pub(super) lists: CandidateLists,
    /// Scratch: the slots whose candidates are compared, and those candidates.
    slots: BitSet,
    rows: BitSet,
}

impl Candidates {
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

    /// Makes `found` the candidates, and leaves the memory of the former ones there.
    pub(super) fn replace<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        found: &mut Vec<[u32; 2]>,
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        self.lists.forget();
        comparing(&mut self.array, proxies, report).replace(found);
    }

    /// Adds candidates.
    pub(super) fn extend<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        found: &[[u32; 2]],
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        let first = self.array.rows();
        comparing(&mut self.array, proxies, report).extend(found);
        self.lists.extend(&self.array, first, proxies.len());
    }

    /// Brings the candidates of what was touched up to date with the present boxes, and retires those of the leavers. Looks at all
    /// candidates, or only at these. Returns what it took.
    ///
    /// Picking a few candidates out of all is cheap, and walking lists is not: it waits for memory at each step. So lists are
    /// for very few.
    pub(super) fn compare<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        mode: CompareMode,
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) -> Work {
        let mut work = Work::default();
        match mode {
            CompareMode::All => self.compact(),
            CompareMode::Listed if !self.lists.state().are_made => {
                self.compact();
                self.lists.make(&self.array, proxies.len());
            }
            _ => {}
        }
        let (array, lists) = (&mut self.array, &mut self.lists);
        let (slots, rows) = (&mut self.slots, &mut self.rows);
        let touched = proxies.touched();
        let mut comparing = comparing(array, proxies, report);
        match mode {
            CompareMode::All => {
                if comparing.compare_all(rows) {
                    lists.forget();
                }
                work.compared = array.rows();
            }
            CompareMode::Picked { lists_are_missed } => {
                work.picked = comparing.array.rows();
                slots.insert_all(touched, proxies.len());
                let is_touched = slots.lookup();
                comparing.array.pick(rows, |slot| is_touched(slot as usize));
                drop(is_touched);
                for row in rows.iter() {
                    work.compared += 1;
                    comparing.compare_or_retire(row);
                }
                slots.clear_around(touched);
                if lists_are_missed {
                    lists.miss();
                }
            }
            CompareMode::Listed => {
                for &slot in proxies.leavers.slots() {
                    lists.take(slot, |row| comparing.retire(row));
                }
                for &slot in touched {
                    lists.walk(slot, |row| comparing.compare(row));
                }
                work.walked = touched.len();
            }
        }
        work
    }

    /// Brings the candidates of what has another volume in the same box up to date.
    pub(super) fn compare_volumes<R: Real, const D: usize, K: FilterKey>(
        &mut self,
        proxies: &Proxies<R, D, K>,
        report: &mut impl FnMut(PairChange),
    ) {
        let (array, lists) = (&mut self.array, &mut self.lists);
        let (slots, rows) = (&mut self.slots, &mut self.rows);
        let revolumed = &proxies.notes.revolumed;
        let is_walking_cheaper = policy::is_walking_cheaper(revolumed.len(), array.rows());
        let mut comparing = comparing(array, proxies, report);
        if lists.state().are_made && is_walking_cheaper {
            for &slot in revolumed {
                lists.walk(slot, |row| comparing.compare(row));
            }
            return;
        }
        slots.insert_all(revolumed, proxies.len());
        comparing.compare_near(rows, slots.lookup());
        slots.clear_around(revolumed);
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
}

/// What brings these candidates up to date with the proxies, and reports the changes.
fn comparing<'a, R, const D: usize, K, F>(
    array: &'a mut CandidateArray,
    proxies: &'a Proxies<R, D, K>,
    report: &'a mut F,
) -> Comparing<'a, R, D, K, F> {
    Comparing {
        array,
        proxies,
        report,
    }
}
