//! An order of endpoints that is kept from call to call, and put right by insertion sort.

use crate::endpoints::{Endpoints, SortKey};
use crate::{Aabb, Real};

/// The endpoints of one axis, in the order of the last call.
#[derive(Clone, Debug, Default)]
pub(super) struct CoherentOrder<K> {
    endpoints: Endpoints<K>,
    /// Each endpoint behind its key, in ascending order: lows are `i`, highs `i + n`, so lows come before equal highs.
    entries: Vec<(K, u32)>,
    /// Scratch memory: the endpoints as a sort afresh gives them.
    order: Vec<u32>,
}

impl<K: SortKey> CoherentOrder<K> {
    /// The endpoints of the first axis of `boxes`, in order.
    ///
    /// Computes in **O(n + inversions)** time, where the inversions are the pairs of endpoints that have changed places
    /// since the last call, and at most **O(n log n)**: then, and if there were more or fewer boxes, all is sorted afresh.
    pub(super) fn update<R: Real, const D: usize>(
        &mut self,
        boxes: &[Aabb<R, D>],
    ) -> impl Iterator<Item = u32> + '_ {
        self.endpoints.read(boxes, 0);
        if !self.repair() {
            self.endpoints.sort_keys(&mut self.order);
            let keys = &self.endpoints.keys;
            self.entries.clear();
            self.entries
                .extend(self.order.iter().map(|&e| (keys[e as usize], e)));
        }
        self.entries.iter().map(|entry| entry.1)
    }

    /// Gives the entries their new keys and puts them right by insertion sort, or returns false: there are other endpoints
    /// than there were, or it takes too many moves.
    fn repair(&mut self) -> bool {
        let keys = &self.endpoints.keys;
        if self.entries.len() != keys.len() {
            return false;
        }
        let mut allowed = most_moves(keys.len());
        for i in 0..self.entries.len() {
            let endpoint = self.entries[i].1;
            let entry = (keys[endpoint as usize], endpoint);
            let mut place = i;
            while place > 0 && self.entries[place - 1] > entry {
                self.entries[place] = self.entries[place - 1];
                place -= 1;
            }
            self.entries[place] = entry;
            match allowed.checked_sub(i - place) {
                Some(left) => allowed = left,
                None => return false,
            }
        }
        true
    }
}

/// After how many moves the insertion sort is given up: one for each endpoint and each halving of their number.
fn most_moves(endpoints: usize) -> usize {
    endpoints * endpoints.checked_ilog2().unwrap_or(0) as usize
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

    /// Updates the order and compares it with one that is sorted afresh.
    fn check(order: &mut CoherentOrder<u32>, boxes: &[Aabb<f32, 1>]) {
        let mut expected = Vec::new();
        Endpoints::<u32>::default().sort(boxes, 0, &mut expected);
        assert!(order.update(boxes).eq(expected), "{boxes:?}");
    }

    /// Whether the order can be repaired for these boxes.
    fn is_repaired(order: &CoherentOrder<u32>, boxes: &[Aabb<f32, 1>]) -> bool {
        let mut order = order.clone();
        order.endpoints.read(boxes, 0);
        order.repair()
    }

    #[test]
    fn boxes_that_drift_are_not_sorted_afresh() {
        let mut random = Rand32::new(1);
        let mut order = CoherentOrder::default();
        let mut boxes = random_boxes(1000, &mut random);
        check(&mut order, &boxes);
        for _ in 0..50 {
            for b in &mut boxes {
                // Half a unit, on which begin two boxes and end two.
                let step = (random.rand_range(0..3) as f32 - 1.0) * 0.5;
                *b = Aabb::new([b.mins[0] + step], [b.maxs[0] + step]);
            }
            assert!(is_repaired(&order, &boxes));
            check(&mut order, &boxes);
        }
    }

    #[test]
    fn boxes_that_jump_and_other_numbers_of_boxes_are_sorted_afresh() {
        let mut random = Rand32::new(2);
        let mut order = CoherentOrder::default();
        assert!(!is_repaired(&order, &random_boxes(1, &mut random)));
        for n in [1000, 1000, 1000, 1001, 999, 0, 1, 2000, 2000] {
            let boxes = random_boxes(n, &mut random);
            assert!(!is_repaired(&order, &boxes) || n == 0 && order.entries.is_empty());
            check(&mut order, &boxes);
        }
    }

    #[test]
    fn the_insertion_sort_is_given_up_at_its_bound() {
        // Points that are far apart, but for the last: that is moved before `passed` others, and so are its two endpoints.
        let points = |n: usize, passed: usize| {
            let low = (1..n).map(|i| i as f32).chain([(n - passed) as f32 - 0.5]);
            low.map(|x| Aabb::new([x], [x])).collect::<Vec<_>>()
        };
        for n in [2, 10, 100, 1000] {
            let mut order = CoherentOrder::default();
            check(&mut order, &points(n, 0));
            // Twice as many moves as endpoints, less than the bound for more than two boxes.
            assert!(is_repaired(&order, &points(n, n - 1)));
            check(&mut order, &points(n, n - 1));
        }
        // Turned around, `2 n` endpoints take `n (n - 1) / 2` moves of four, which is less than `2 n log₂ 2 n`, rounded
        // down, for up to 5 boxes.
        for n in 1..40 {
            let ascending: Vec<_> = (0..n).map(|i| Aabb::new([i as f32], [i as f32])).collect();
            let descending: Vec<_> = ascending.iter().rev().copied().collect();
            let mut order = CoherentOrder::default();
            check(&mut order, &ascending);
            assert_eq!(
                is_repaired(&order, &descending),
                4 * n * (n - 1) / 2 <= most_moves(2 * n)
            );
            check(&mut order, &descending);
        }
        assert_eq!(most_moves(0), 0);
        assert_eq!(most_moves(2000), 20_000);
    }
}
