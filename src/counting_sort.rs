//! The two steps of every counting sort: counts become starts, then each item takes the next place of its bucket.

/// Turns the number of items in each bucket into the place of the bucket's first item.
#[inline]
pub(crate) fn starts_from_counts(counts: &mut [u32]) {
    let mut start = 0;
    for count in counts {
        start += core::mem::replace(count, start);
    }
}

/// Returns the place of the next item of a bucket. Once all items have their places, `next` holds the ends of the buckets.
#[inline(always)]
pub(crate) fn take_place(next: &mut [u32], bucket: usize) -> usize {
    let next = &mut next[bucket];
    let place = *next;
    *next += 1;
    place as usize
}
