//! The order of a tube's entries along the first axis.
//!
//! Most of the work of finding pairs is sorting, so it is done where it is cheap: a tube fits in the first- or
//! second-level cache. Entries are dealt into as many buckets as there are entries by a linear guess. What the
//! guess misplaces, about one in four, is put right by insertion.

use crate::Real;
use crate::tuning::kernel::{CROWDED_BUCKET, INSERTION_UP_TO};

/// Sorts numbers into an order; keeps its memory between calls.
#[derive(Clone, Debug, Default)]
pub(super) struct Order<R> {
    /// The numbers and their positions.
    sorted: Vec<(R, u32)>,
    /// For each bucket, where its next number goes.
    cursors: Vec<u32>,
}

impl<R: Real> Order<R> {
    /// The numbers with their positions, ascending; equal ones by position. There must be no NaN.
    #[inline]
    pub(super) fn sort(
        &mut self,
        numbers: impl ExactSizeIterator<Item = R> + Clone,
    ) -> &[(R, u32)] {
        if numbers.len() <= INSERTION_UP_TO {
            self.sorted.clear();
            self.sorted.extend(numbers.zip(0..));
        } else {
            self.deal(numbers);
        }
        insertion_sort(&mut self.sorted);
        &self.sorted
    }

    /// Brings the numbers nearly into order: deals each into its bucket. Buckets ascend, and dealing is
    /// stable.
    #[inline]
    fn deal(&mut self, numbers: impl ExactSizeIterator<Item = R> + Clone) {
        let Self { sorted, cursors } = self;
        let count = numbers.len();
        let [low, high] = range(numbers.clone());
        let length = (high.to_f64() - low.to_f64()).max(0.0);
        let per_length = R::from_f64(count as f64 / length);
        cursors.clear();
        cursors.resize(count, 0);
        let cursors = &mut cursors[..];
        let last = cursors.len() - 1;
        // Non-decreasing in x, like the strips of a grid.
        let bucket_of = |x: R| {
            let offset = (x - low) * per_length;
            let [bucket, ..] = R::truncated([offset, R::ZERO, R::ZERO, R::ZERO]);
            (bucket as usize).min(last)
        };
        for x in numbers.clone() {
            cursors[bucket_of(x)] += 1;
        }
        let mut end = 0;
        let mut most = 0;
        for cursor in &mut *cursors {
            most = most.max(*cursor);
            end += std::mem::replace(cursor, end);
        }
        // All of it is written below.
        sorted.resize(count, (R::ZERO, 0));
        let sorted = &mut sorted[..count];
        for number in numbers.zip(0..) {
            let cursor = &mut cursors[bucket_of(number.0)];
            sorted[*cursor as usize] = number;
            *cursor += 1;
        }
        if most > CROWDED_BUCKET {
            let mut start = 0;
            // Each cursor now stands at the end of its bucket.
            for &end in cursors.iter() {
                if end - start > CROWDED_BUCKET {
                    sorted[start as usize..end as usize]
                        .sort_by(|(a, _), (b, _)| a.partial_cmp(b).expect("numbers are not NaN"));
                }
                start = end;
            }
        }
    }
}

/// The least and the greatest of the finite numbers. Infinite ones must not spoil the guess.
#[inline]
fn range<R: Real>(numbers: impl Iterator<Item = R> + Clone) -> [R; 2] {
    fn widest<R: Real>(numbers: impl Iterator<Item = R>) -> [R; 2] {
        numbers.fold([R::MAX, R::ZERO - R::MAX], |[low, high], x| {
            [
                if x < low { x } else { low },
                if x > high { x } else { high },
            ]
        })
    }
    let found = widest(numbers.clone());
    if found.iter().all(|x| x.is_finite()) {
        return found;
    }
    widest(numbers.filter(|x| x.is_finite()))
}

/// Sorts by insertion: fast when few numbers are far from their place. Stable.
fn insertion_sort<R: Real>(numbers: &mut [(R, u32)]) {
    for i in 1..numbers.len() {
        let number = numbers[i];
        let mut hole = i;
        while hole > 0 && number.0 < numbers[hole - 1].0 {
            numbers[hole] = numbers[hole - 1];
            hole -= 1;
        }
        numbers[hole] = number;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(numbers: &[f32]) {
        let mut order = Order::default();
        let sorted = order.sort(numbers.iter().copied()).to_vec();
        let mut expected: Vec<_> = numbers.iter().copied().zip(0..).collect();
        expected.sort_by(|a, b| a.0.partial_cmp(&b.0).unwrap());
        assert_eq!(sorted, expected);
    }

    #[test]
    fn sorts_stably_whatever_the_distribution() {
        let mut state = 1_u32;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32
        };
        for n in (0..60).chain([500, 3000]) {
            let uniform: Vec<f32> = (0..n).map(|_| next()).collect();
            check(&uniform);
            check(&uniform.iter().map(|x| x % 7.0).collect::<Vec<_>>());
            check(&uniform.iter().map(|x| x.exp()).collect::<Vec<_>>());
            check(&vec![3.0; n]);
            let mut outlier = uniform.clone();
            outlier.extend([
                1e30,
                f32::NEG_INFINITY,
                f32::INFINITY,
                f32::MAX,
                f32::MIN,
                -0.0,
                0.0,
            ]);
            check(&outlier);
        }
    }
}
