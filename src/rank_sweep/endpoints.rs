//! The endpoints of boxes on one axis, in order.
//!
//! An axis has `2n` endpoints: the low one of object `i` at `i`, the high one at `i + n`. They are sorted by one stable
//! radix sort of integers (`crate::radix_sort`). It puts low endpoints before equal high ones, as closed boxes require, and
//! each kind in the order of object ids.

use crate::aabb::Aabb;
use crate::radix_sort::{RadixSort, SortKey};
use crate::real::Real;

/// The endpoints of one axis. All of it is scratch memory.
#[derive(Clone, Debug, Default)]
pub(super) struct Endpoints<K> {
    /// Integers that compare as the coordinates do: lows at `i`, highs at `i + n`.
    pub(super) keys: Vec<K>,
    sorter: RadixSort<K>,
}

impl<K: SortKey> Endpoints<K> {
    /// Sorts the endpoints of an axis.
    ///
    /// Computes in **O(n)** time.
    pub(super) fn sort<R: Real<Key = K>, const D: usize>(
        &mut self,
        boxes: &[Aabb<R, D>],
        axis: usize,
        order: &mut Vec<u32>,
    ) {
        let (lows, highs) = (boxes.iter(), boxes.iter());
        self.keys.clear();
        self.keys.extend(lows.map(|b| b.mins[axis].order_key()));
        self.keys.extend(highs.map(|b| b.maxs[axis].order_key()));
        let indexed = self.keys.iter().enumerate();
        let indexed = indexed.map(|(i, &key)| (key, i as u32));
        self.sorter.sort(indexed, |(_, index)| index, order);
    }
}
