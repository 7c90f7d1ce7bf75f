//! Sweep and prune for coherent motion: what hardly changes from call to call is kept.

use super::active_list::ActiveList;
use super::coherent_order::CoherentOrder;
use crate::endpoints::{check_count, has_narrow_keys};
use crate::pair_finder::check_boxes;
use crate::{Aabb, InvalidInput, PairFinder, Real};

/// Sweep and prune on one axis whose order is kept from call to call and repaired by insertion sort: Baraff, *Dynamic
/// simulation of non-penetrating rigid bodies* (1992), and Cohen and others, *I-COLLIDE* (1995).
///
/// It differs from [`SweepAndPrune`](crate::SweepAndPrune) only in the sort, and returns the same pairs in the same
/// order: what it keeps affects only the time. Those papers also keep the overlaps on all axes, and update them whenever
/// two endpoints change places. A [`PairFinder`] returns all pairs, so here they are found by a sweep.
///
/// Computes in **O(n k + m)** time, where k is how many boxes overlap at once on the first axis and m how many pairs of
/// endpoints have changed places on it since the last call, and **O(n)** memory beside the pairs. The insertion sort is
/// given up, and everything is sorted afresh in **O(n)**, as soon as it has taken more than 16384 moves plus eight for
/// each endpoint that it has passed, or if the number of boxes has changed since the last call. So where boxes jump, m
/// counts for no more than n.
///
/// The axes are taken in the given order: let the first be one along which boxes are spread out. `D` must not be 0.
///
/// At most 2³¹ - 1 boxes, because each has two endpoints; more are refused as
/// [`TooMany`](crate::InvalidInputReason::TooMany).
#[derive(Clone, Debug, Default)]
pub struct CoherentSweepAndPrune<R, const D: usize> {
    /// The order by keys of 32 bits, empty unless `R` is `f32`.
    narrow: CoherentOrder<u32>,
    /// The order by keys of 64 bits, empty unless `R` is `f64`.
    wide: CoherentOrder<u64>,
    active: ActiveList<R, D>,
}

impl<R: Real, const D: usize> PairFinder<R, D> for CoherentSweepAndPrune<R, D> {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        const { assert!(D > 0, "boxes need an axis") };
        pairs.clear();
        check_count(boxes.len())?;
        check_boxes(boxes)?;
        if has_narrow_keys::<R>() {
            self.active.sweep(self.narrow.update(boxes), boxes, pairs);
        } else {
            self.active.sweep(self.wide.update(boxes), boxes, pairs);
        }
        Ok(())
    }
}
