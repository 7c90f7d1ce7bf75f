//! An order of endpoints that is kept from call to call and repaired by insertion sort.

use core::fmt::Debug;

use crate::endpoints::{Endpoints, SortKey};
use crate::{Aabb, Real};

/// Moves per endpoint. With more, the insertion sort is given up: measured, sorting afresh takes as long.
const MOST_MOVES: usize = 8;

/// This many more moves are always allowed. Where everything jumps, no more than these are wasted.
const FREE_MOVES: usize = 1 << 14;

/// A key that endpoints are sorted by, and an integer that holds key and endpoint: comparing one number is faster than
/// comparing two.
pub(super) trait EntryKey: SortKey {
    /// A key in the high bits, its endpoint in the low bits.
    type Entry: Copy + Debug + Default + Ord;
    fn entry(self, endpoint: u32) -> Self::Entry;
    fn endpoint(entry: Self::Entry) -> u32;
}

macro_rules! impl_entry_key {
    ($key:ident, $entry:ident) => {
        impl EntryKey for $key {
            type Entry = $entry;

            #[inline]
            fn entry(self, endpoint: u32) -> $entry {
                $entry::from(self) << u32::BITS | $entry::from(endpoint)
            }
            #[inline]
            fn endpoint(entry: $entry) -> u32 {
                entry as u32
            }
        }
    };
}

impl_entry_key!(u32, u64);
impl_entry_key!(u64, u128);

/// The endpoints of one axis, in the order of the last call.
#[derive(Clone, Debug, Default)]
pub(super) struct CoherentOrder<K: EntryKey> {
    endpoints: Endpoints<K>,
    /// In ascending order. Lows are `i`, highs `i + n`, so lows come before equal highs.
    entries: Vec<K::Entry>,
    /// Scratch memory: the endpoints in the order of a fresh sort.
    order: Vec<u32>,
}

impl<K: EntryKey> CoherentOrder<K> {
    /// The endpoints of the first axis of `boxes`, in order.
    ///
    /// Computes in **O(n + inversions)** time, where the inversions are the pairs of endpoints that have changed places
    /// since the last call, and at most in **O(n)**: if there are many inversions, or the number of boxes has changed,
    /// everything is sorted afresh.
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
                .extend(self.order.iter().map(|&e| keys[e as usize].entry(e)));
        }
        self.entries.iter().map(|&entry| K::endpoint(entry))
    }

    /// Gives the entries their new keys and repairs their order by insertion sort. Returns false if the number of
    /// endpoints has changed, or if it takes too many moves.
    fn repair(&mut self) -> bool {
        let keys = &self.endpoints.keys;
        if self.entries.len() != keys.len() {
            return false;
        }
        let mut allowed = FREE_MOVES;
        for i in 0..self.entries.len() {
            let endpoint = K::endpoint(self.entries[i]);
            let entry = keys[endpoint as usize].entry(endpoint);
            let mut place = i;
            while place > 0 && self.entries[place - 1] > entry {
                self.entries[place] = self.entries[place - 1];
                place -= 1;
            }
            self.entries[place] = entry;
            match (allowed + MOST_MOVES).checked_sub(i - place) {
                Some(left) => allowed = left,
                None => return false,
            }
        }
        true
    }
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
                // Half a unit: at each such coordinate about two boxes begin and two end.
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
        // Points far apart, except the last: it is moved before `passed` others, with both of its endpoints.
        let points = |n: usize, passed: usize| {
            let low = (1..n).map(|i| i as f32).chain([(n - passed) as f32 - 0.5]);
            low.map(|x| Aabb::new([x], [x])).collect::<Vec<_>>()
        };
        for n in [2, 10, 100, 1000] {
            let mut order = CoherentOrder::default();
            check(&mut order, &points(n, 0));
            // Twice as many moves as endpoints.
            assert!(is_repaired(&order, &points(n, n - 1)));
            check(&mut order, &points(n, n - 1));
        }
        // Every two of the n points pass each other, each with two endpoints.
        for n in (1..200).step_by(3) {
            let ascending: Vec<_> = (0..n).map(|i| Aabb::new([i as f32], [i as f32])).collect();
            let descending: Vec<_> = ascending.iter().rev().copied().collect();
            let mut order = CoherentOrder::default();
            check(&mut order, &ascending);
            let moves = 4 * n * (n - 1) / 2;
            let allowed = FREE_MOVES + MOST_MOVES * 2 * n;
            assert_eq!(is_repaired(&order, &descending), moves <= allowed);
            check(&mut order, &descending);
        }
    }
}
