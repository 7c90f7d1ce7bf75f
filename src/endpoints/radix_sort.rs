//! A stable radix sort: of keys, which stay in place and whose indexes are returned in order, or of entries that are moved.
//!
//! Least significant digit first, as in section 3 of the paper: each pass deals the entries out by one digit. A pass
//! keeps the order of equal digits, so entries of equal keys come out in the order of their indexes. All digits are
//! counted beforehand, in one pass over the keys; a digit that all keys share needs no pass of its own. The first pass
//! reads the bare keys and the last writes bare indexes, so only the passes between move both.

use core::fmt::Debug;

/// Bits of a digit of many keys. Three passes sort keys of 32 bits and six those of 64, and the counts of a digit fit in
/// the first-level cache; a whole frame takes a tenth less time than with digits of 8 bits.
const LARGE_DIGIT: u32 = 11;
/// Bits of a digit of few keys, where clearing and adding up the counts would outweigh the passes saved.
const SMALL_DIGIT: u32 = 8;
/// From this many keys on, digits are large. Measured: half as many favour small digits, twice as many large ones, in
/// both widths of key.
const FEW: usize = 1 << 10;

/// An unsigned integer that is sorted by.
pub(crate) trait SortKey: Copy + Ord + Debug + Default + Send + Sync {
    /// How many bits it has.
    const BITS: u32;
    /// The low bits of an [`order_key`](crate::Real::order_key).
    fn from_order_key(key: u64) -> Self;
    /// The value of the `BITS` bits from bit `shift` on.
    fn digit<const BITS: u32>(self, shift: u32) -> usize;
}

macro_rules! impl_sort_key {
    ($int:ident) => {
        impl SortKey for $int {
            const BITS: u32 = $int::BITS;

            #[inline]
            fn from_order_key(key: u64) -> Self {
                key as Self
            }
            #[inline]
            fn digit<const BITS: u32>(self, shift: u32) -> usize {
                (self >> shift) as usize & ((1 << BITS) - 1)
            }
        }
    };
}

impl_sort_key!(u32);
impl_sort_key!(u64);

/// The scratch memory of the sort.
#[derive(Clone, Debug, Default)]
pub(crate) struct RadixSort<K> {
    /// What the next pass reads: keys and their indexes.
    from: Vec<(K, u32)>,
    /// What the next pass writes.
    to: Vec<(K, u32)>,
    /// One row per digit: how many keys have each value, then where the next such key goes.
    counts: Vec<u32>,
}

impl<K: SortKey> RadixSort<K> {
    /// Replaces `order` by the indexes of `keys`, in the order of the keys; the indexes of equal keys ascend. There are
    /// at most `u32::MAX` keys.
    ///
    /// Computes in **O(n)** time.
    pub(crate) fn sort(&mut self, keys: &[K], order: &mut Vec<u32>) {
        if keys.len() < FEW {
            self.sort_by_digits::<SMALL_DIGIT>(keys, order);
        } else {
            self.sort_by_digits::<LARGE_DIGIT>(keys, order);
        }
    }

    fn sort_by_digits<const BITS: u32>(&mut self, keys: &[K], order: &mut Vec<u32>) {
        let Self { from, to, counts } = self;
        let indexed = || keys.iter().copied().zip(0..);
        count_digits::<K, BITS>(keys.iter().copied(), counts);
        let mut passes = passes::<K, BITS>(counts, keys.first(), keys.len()).peekable();

        order.clear();
        let Some((row, shift)) = passes.next() else {
            order.extend(0..keys.len() as u32);
            return;
        };
        order.resize(keys.len(), 0);
        if passes.peek().is_none() {
            deal::<K, BITS>(indexed(), row, shift, |at, entry| order[at] = entry.1);
            return;
        }
        from.resize(keys.len(), Default::default());
        to.resize(keys.len(), Default::default());
        deal::<K, BITS>(indexed(), row, shift, |at, entry| from[at] = entry);
        while let Some((row, shift)) = passes.next() {
            let entries = from.iter().copied();
            if passes.peek().is_none() {
                deal::<K, BITS>(entries, row, shift, |at, entry| order[at] = entry.1);
            } else {
                deal::<K, BITS>(entries, row, shift, |at, entry| to[at] = entry);
                core::mem::swap(from, to);
            }
        }
    }

    /// Sorts entries by their keys; those of equal keys stay in order. There are at most `u32::MAX`.
    ///
    /// Computes in **O(n)** time.
    pub(crate) fn sort_entries(&mut self, entries: &mut Vec<(K, u32)>) {
        if entries.len() < FEW {
            self.sort_entries_by_digits::<SMALL_DIGIT>(entries);
        } else {
            self.sort_entries_by_digits::<LARGE_DIGIT>(entries);
        }
    }

    fn sort_entries_by_digits<const BITS: u32>(&mut self, entries: &mut Vec<(K, u32)>) {
        let Self { to, counts, .. } = self;
        to.resize(entries.len(), Default::default());
        count_digits::<K, BITS>(entries.iter().map(|&(key, _)| key), counts);
        let first = entries.first().map(|&(key, _)| key);
        for (row, shift) in passes::<K, BITS>(counts, first.as_ref(), entries.len()) {
            deal::<K, BITS>(entries.iter().copied(), row, shift, |at, entry| {
                to[at] = entry
            });
            core::mem::swap(entries, to);
        }
    }
}

/// The digits of which the keys have more than one value, the lowest first: the row of counts, and the digit's first bit.
fn passes<'a, K: SortKey, const BITS: u32>(
    counts: &'a mut [u32],
    first: Option<&K>,
    len: usize,
) -> impl Iterator<Item = (&'a mut [u32], u32)> + use<'a, K, BITS> {
    let first = first.copied().unwrap_or_default();
    let rows = counts.chunks_exact_mut(1 << BITS);
    rows.zip((0..K::BITS).step_by(BITS as usize))
        .filter(move |(row, shift)| row[first.digit::<BITS>(*shift)] as usize != len)
}

/// Counts the values of every digit, one row of `counts` per digit.
fn count_digits<K: SortKey, const BITS: u32>(keys: impl Iterator<Item = K>, counts: &mut Vec<u32>) {
    counts.clear();
    counts.resize((K::BITS.div_ceil(BITS) as usize) << BITS, 0);
    for key in keys {
        let mut row = 0;
        for shift in (0..K::BITS).step_by(BITS as usize) {
            counts[row + key.digit::<BITS>(shift)] += 1;
            row += 1 << BITS;
        }
    }
}

/// One pass: hands every entry to `put`, with the place that its digit gives it.
#[inline]
fn deal<K: SortKey, const BITS: u32>(
    entries: impl Iterator<Item = (K, u32)>,
    counts: &mut [u32],
    shift: u32,
    mut put: impl FnMut(usize, (K, u32)),
) {
    let mut place = 0;
    for count in &mut *counts {
        place += core::mem::replace(count, place);
    }
    for (key, index) in entries {
        let next = &mut counts[key.digit::<BITS>(shift)];
        put(*next as usize, (key, index));
        *next += 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check<K: SortKey>(keys: &[K]) {
        let mut expected: Vec<u32> = (0..keys.len() as u32).collect();
        expected.sort_by_key(|&i| keys[i as usize]);
        let (mut sorter, mut order) = (RadixSort::default(), vec![7; 3]);
        sorter.sort_by_digits::<SMALL_DIGIT>(keys, &mut order);
        assert_eq!(order, expected, "{keys:?}");
        sorter.sort_by_digits::<LARGE_DIGIT>(keys, &mut order);
        assert_eq!(order, expected, "{keys:?}");
        sorter.sort(keys, &mut order);
        assert_eq!(order, expected, "{keys:?}");

        let entries: Vec<_> = keys.iter().copied().zip(0..).collect();
        let expected: Vec<_> = expected.iter().map(|&i| entries[i as usize]).collect();
        let sorts = [
            RadixSort::sort_entries_by_digits::<SMALL_DIGIT>,
            RadixSort::sort_entries_by_digits::<LARGE_DIGIT>,
            RadixSort::sort_entries,
        ];
        for sort in sorts {
            let mut entries = entries.clone();
            sort(&mut sorter, &mut entries);
            assert_eq!(entries, expected);
        }
    }

    /// Keys that differ only in `bits`, so that every choice of constant digits comes up.
    fn check_bits(random: &mut oorandom::Rand64, len: usize, bits: u64) {
        let keys: Vec<u64> = (0..len)
            .map(|_| random.rand_u64() & bits | 0xA5A5_A5A5_A5A5_A5A5 & !bits)
            .collect();
        check(&keys);
        check(&keys.iter().map(|&key| key as u32).collect::<Vec<_>>());
    }

    #[test]
    fn agrees_with_the_stable_sort_of_the_standard_library() {
        let mut random = oorandom::Rand64::new(1);
        for len in (0..20).chain([255, 256, 257, 1000, FEW - 1, FEW, FEW + 1]) {
            check_bits(&mut random, len, u64::MAX);
            check_bits(&mut random, len, 0);
            for digit in 0..8 {
                check_bits(&mut random, len, 0xFF << (8 * digit));
                check_bits(&mut random, len, 0x3 << (8 * digit + 3));
            }
        }
        for _ in 0..500 {
            let len = random.rand_range(0..300) as usize;
            let bits = random.rand_u64() & random.rand_u64() & random.rand_u64();
            check_bits(&mut random, len, bits);
        }
    }

    #[test]
    fn scratch_of_another_length_does_no_harm() {
        let mut sorter = RadixSort::<u32>::default();
        let mut order = Vec::new();
        for len in [5000, 3, 0, 100, 9000] {
            let keys: Vec<u32> = (0..len).map(|i: u32| i.wrapping_mul(0x9E37_79B9)).collect();
            sorter.sort(&keys, &mut order);
            assert!(order.is_sorted_by_key(|&i| keys[i as usize]));
            assert_eq!(order.len(), keys.len());
        }
    }
}
