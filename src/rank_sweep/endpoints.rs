//! The endpoints of boxes on one axis, in order.
//!
//! An axis has `2n` endpoints: the low one of object `i` at `i`, the high one at `i + n`. They are sorted by one stable
//! radix sort of integers (`crate::radix_sort`). It puts low endpoints before equal high ones, as closed boxes require, and
//! each kind in the order of object ids.

use crate::aabb::Aabb;
use crate::invalid_input::{InvalidInput, InvalidInputReason};
use crate::radix_sort::{RadixSort, SortKey};
use crate::real::Real;

/// Two endpoints per box, numbered by `u32`, with one number to spare.
pub(super) const MAX_BOXES: usize = (u32::MAX / 2) as usize;

/// Whether coordinates of this type are sorted by keys of 32 bits; otherwise by keys of 64.
pub(super) const fn has_narrow_keys<R>() -> bool {
    size_of::<R>() == size_of::<u32>()
}

/// Refuses more boxes than there are numbers for their endpoints.
pub(super) fn check_count(count: usize) -> Result<(), InvalidInput> {
    if count > MAX_BOXES {
        return Err(InvalidInput::new(MAX_BOXES, InvalidInputReason::TooMany));
    }
    Ok(())
}

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
    pub(super) fn sort<R: Real, const D: usize>(
        &mut self,
        boxes: &[Aabb<R, D>],
        axis: usize,
        order: &mut Vec<u32>,
    ) {
        let key = |x: R| K::from_order_key(x.order_key());
        self.keys.clear();
        self.keys.extend(boxes.iter().map(|b| key(b.mins[axis])));
        self.keys.extend(boxes.iter().map(|b| key(b.maxs[axis])));
        let indexed = self.keys.iter().enumerate();
        let indexed = indexed.map(|(i, &key)| (key, i as u32));
        self.sorter.sort(indexed, |(_, index)| index, order);
    }
}
