//! A stable radix sort of indices by integer keys.
//!
//! Least significant digit first, as in section 3 of the paper: each pass is a counting sort by one digit, and keeps the order of equal
//! digits. One pass over the keys counts all digits beforehand. The first pass reads the keys where they are, and the last writes
//! indices only. So only the passes between move both.

use crate::counting_sort::{starts_from_counts, take_place};

/// Bits of a digit if there are many keys. Three passes sort keys of 32 bits and six those of 64, and the counts of a digit fit in the
/// first-level cache. A whole search takes a tenth less time than with digits of 8 bits.
const LARGE_DIGIT: u32 = 11;
/// Bits of a digit if there are few keys: clearing and adding up more counts would take longer than the passes that they save.
const SMALL_DIGIT: u32 = 8;
/// From this many keys on, digits are large. Small digits are faster for half as many keys, and large ones for twice as many, in both
/// widths of key.
const FEW: usize = 1 << 10;

/// The scratch memory of the sort.
#[derive(Clone, Debug, Default)]
pub(crate) struct RadixSort<K> {
    /// The next pass reads these entries.
    from: Vec<(K, u32)>,
    /// The next pass writes these entries.
    to: Vec<(K, u32)>,
    /// A row for each digit: how many keys have each value of it, then the place of the next such key.
    counts: Vec<u32>,
}

impl<K: Copy + Default + Into<u64>> RadixSort<K> {
    /// Replaces `order` by the indices of at most `u32::MAX` keys, in the order of the keys; indices of equal keys ascend.
    ///
    /// Computes in **O(n)** time.
    pub(crate) fn sort(&mut self, keys: &[K], order: &mut Vec<u32>) {
        match keys.len() < FEW {
            true => self.sort_by_digits::<SMALL_DIGIT>(keys, order),
            false => self.sort_by_digits::<LARGE_DIGIT>(keys, order),
        }
    }

    fn sort_by_digits<const BITS: u32>(&mut self, keys: &[K], order: &mut Vec<u32>) {
        let Self { from, to, counts } = self;
        count_digits::<K, BITS>(keys, counts);
        // A digit that all keys share needs no pass.
        let first = keys.first().copied().unwrap_or_default();
        let mut passes = counts
            .chunks_exact_mut(1 << BITS)
            .zip(shifts::<K, BITS>())
            .filter(|(row, shift)| row[digit::<BITS>(first, *shift)] as usize != keys.len())
            .peekable();

        let entries = keys.iter().copied().zip(0..);
        order.clear();
        let Some(digit) = passes.next() else {
            order.extend(entries.map(|(_, index)| index));
            return;
        };
        order.resize(keys.len(), 0);
        let order = &mut order[..];
        if passes.peek().is_none() {
            return pass::<K, BITS>(entries, digit, |at, (_, index)| order[at] = index);
        }
        from.resize(keys.len(), Default::default());
        to.resize(keys.len(), Default::default());
        let (mut from, mut to) = (&mut from[..], &mut to[..]);
        pass::<K, BITS>(entries, digit, |at, entry| from[at] = entry);
        while let Some(digit) = passes.next() {
            let entries = from.iter().copied();
            if passes.peek().is_none() {
                pass::<K, BITS>(entries, digit, |at, (_, index)| order[at] = index);
            } else {
                pass::<K, BITS>(entries, digit, |at, entry| to[at] = entry);
                core::mem::swap(&mut from, &mut to);
            }
        }
    }
}

/// Returns the first bit of each digit of a key, the least significant digit first.
fn shifts<K, const BITS: u32>() -> impl ExactSizeIterator<Item = u32> {
    (0..8 * size_of::<K>() as u32).step_by(BITS as usize)
}

/// Returns the digit of a key whose first bit is `shift`.
#[inline]
fn digit<const BITS: u32>(key: impl Into<u64>, shift: u32) -> usize {
    (key.into() >> shift) as usize & ((1 << BITS) - 1)
}

/// Counts the values of all digits, in one row of `counts` per digit.
fn count_digits<K: Copy + Into<u64>, const BITS: u32>(keys: &[K], counts: &mut Vec<u32>) {
    counts.clear();
    counts.resize(shifts::<K, BITS>().len() << BITS, 0);
    for &key in keys {
        let mut row = 0;
        for shift in shifts::<K, BITS>() {
            counts[row + digit::<BITS>(key, shift)] += 1;
            row += 1 << BITS;
        }
    }
}

/// One pass: calls `put` with each entry and its place by this digit.
#[inline]
fn pass<K: Copy + Into<u64>, const BITS: u32>(
    entries: impl Iterator<Item = (K, u32)>,
    (counts, shift): (&mut [u32], u32),
    mut put: impl FnMut(usize, (K, u32)),
) {
    starts_from_counts(counts);
    for entry in entries {
        put(take_place(counts, digit::<BITS>(entry.0, shift)), entry);
    }
}
