//! Sweep and prune for coherent motion: the order of the endpoints is kept from call to call, and repaired by insertion sort.

use crate::active_list::ActiveList;
use crate::check_boxes;
use crate::endpoints::{self, Endpoint};
use unisize::{Aabb, InvalidInput, PairFinder, Real};

/// Moves per endpoint. With more, the insertion sort is given up: measured, sorting afresh takes as long.
const MOST_MOVES: usize = 8;

/// This many more moves are always allowed. Where everything jumps, no more than these are wasted.
const FREE_MOVES: usize = 1 << 14;

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
#[derive(Clone, Debug, Default)]
pub struct CoherentSweepAndPrune<R, const D: usize> {
    /// In the order of the last call.
    endpoints: Vec<Endpoint<R>>,
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
        check_boxes(boxes)?;
        if !repair(boxes, &mut self.endpoints) {
            endpoints::sort(boxes, 0, &mut self.endpoints);
        }
        let order = self.endpoints.iter().map(|&(_, endpoint)| endpoint);
        self.active.sweep(order, boxes, pairs);
        Ok(())
    }
}

/// Gives the endpoints their new coordinates and repairs their order by insertion sort. Returns false, and leaves them in
/// no order, if their number has changed or if it takes too many moves.
fn repair<R: Real, const D: usize>(boxes: &[Aabb<R, D>], endpoints: &mut [Endpoint<R>]) -> bool {
    if endpoints.len() != 2 * boxes.len() {
        return false;
    }
    let mut allowed = FREE_MOVES;
    for i in 0..endpoints.len() {
        let (_, endpoint) = endpoints[i];
        let moved = (endpoints::coordinate(boxes, 0, endpoint), endpoint);
        let mut place = i;
        while place > 0 && endpoints[place - 1] > moved {
            endpoints[place] = endpoints[place - 1];
            place -= 1;
        }
        endpoints[place] = moved;
        match (allowed + MOST_MOVES).checked_sub(i - place) {
            Some(left) => allowed = left,
            None => return false,
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;
    use oorandom::Rand32;

    fn random_boxes(n: usize, random: &mut Rand32) -> Vec<Aabb<f32, 1>> {
        let mut interval = || {
            let low = random.rand_range(0..n as u32 / 2 + 1) as f32 * 0.5;
            Aabb::new([low], [low + random.rand_range(0..4) as f32 * 0.5])
        };
        (0..n).map(|_| interval()).collect()
    }

    fn sorted(boxes: &[Aabb<f32, 1>]) -> Vec<Endpoint<f32>> {
        let mut endpoints = Vec::new();
        endpoints::sort(boxes, 0, &mut endpoints);
        endpoints
    }

    #[test]
    fn boxes_that_drift_are_not_sorted_afresh() {
        let mut random = Rand32::new(1);
        let mut boxes = random_boxes(1000, &mut random);
        let mut endpoints = sorted(&boxes);
        for _ in 0..50 {
            for b in &mut boxes {
                // Half a unit: at each such coordinate about two boxes begin and two end.
                let step = (random.rand_range(0..3) as f32 - 1.0) * 0.5;
                *b = Aabb::new([b.mins[0] + step], [b.maxs[0] + step]);
            }
            assert!(repair(&boxes, &mut endpoints));
            assert_eq!(endpoints, sorted(&boxes));
        }
    }

    #[test]
    fn the_insertion_sort_is_given_up_at_its_bound() {
        assert!(!repair(&random_boxes(9, &mut Rand32::new(2)), &mut []));
        // Every two of the n points pass each other, each with two endpoints.
        for n in (1..200).step_by(3) {
            let ascending: Vec<_> = (0..n).map(|i| Aabb::new([i as f32], [i as f32])).collect();
            let descending: Vec<_> = ascending.iter().rev().copied().collect();
            let mut endpoints = sorted(&ascending);
            let (moves, allowed) = (4 * n * (n - 1) / 2, FREE_MOVES + MOST_MOVES * 2 * n);
            assert_eq!(repair(&descending, &mut endpoints), moves <= allowed);
            assert!(moves > allowed || endpoints == sorted(&descending));
        }
    }
}
