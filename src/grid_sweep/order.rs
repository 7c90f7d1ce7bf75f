//! The order of a tube's entries along the first axis.
//!
//! Most of the work of finding pairs is sorting, so it is done where it is cheap: a tube fits in the first- or
//! second-level cache. Entries are sorted into twice as many buckets as there are entries by a linear guess. What the
//! guess misplaces, about one in eight, is put right by insertion.

use crate::counting_sort::{starts_from_counts, take_place};
use crate::lanes::Lanes;
use crate::real::Real;
use crate::tuning::kernel::{BUCKETS_AN_ENTRY, CROWDED_BUCKET, INSERTION_UP_TO};

/// Sorts numbers into an order; keeps its memory between calls.
#[derive(Clone, Debug, Default)]
pub(super) struct Order<R> {
    /// The numbers and their positions.
    sorted: Vec<(R, u32)>,
    /// The bucket of each number.
    buckets: Vec<u32>,
    /// For each bucket how many numbers it has, then where the next of them goes.
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
            self.sort_by_buckets(numbers);
        }
        insertion_sort(&mut self.sorted);
        &self.sorted
    }

    /// Brings the numbers nearly into order: a stable counting sort by buckets, which ascend.
    #[inline]
    fn sort_by_buckets(&mut self, numbers: impl ExactSizeIterator<Item = R> + Clone) {
        let (sorted, buckets, cursors) = (&mut self.sorted, &mut self.buckets, &mut self.cursors);
        let count = numbers.len();
        let bucket_count = BUCKETS_AN_ENTRY * count;
        let [low, high] = range(numbers.clone());
        let length = (high.to_f64() - low.to_f64()).max(0.0);
        let per_length = R::from_f64(bucket_count as f64 / length);
        cursors.clear();
        cursors.resize(bucket_count, 0);
        let cursors = &mut cursors[..];
        let last = cursors.len() - 1;
        // Non-decreasing in the numbers, like the strips of a grid.
        let buckets_of = |numbers: [R; FOUR]| {
            let offsets = numbers.map(|x| (x - low) * per_length);
            R::Lanes::truncated(offsets).map(|bucket| (bucket as usize).min(last))
        };
        buckets.clear();
        let mut rest = numbers.clone();
        for _ in 0..count / FOUR {
            let four = buckets_of([(); FOUR].map(|()| rest.next().expect("counted")));
            four.into_iter().for_each(|bucket| cursors[bucket] += 1);
            buckets.extend_from_slice(&four.map(|bucket| bucket as u32));
        }
        for x in rest {
            let [bucket, ..] = buckets_of([x; FOUR]);
            cursors[bucket] += 1;
            buckets.push(bucket as u32);
        }
        let most = cursors.iter().copied().max().unwrap_or_default();
        starts_from_counts(cursors);
        // All of it is written below.
        sorted.resize(count, (R::ZERO, 0));
        let sorted = &mut sorted[..count];
        for (number, &bucket) in numbers.zip(0..).zip(&buckets[..count]) {
            sorted[take_place(cursors, bucket as usize)] = number;
        }
        if most > CROWDED_BUCKET {
            let mut start = 0;
            for &end in &*cursors {
                if end - start > CROWDED_BUCKET {
                    sorted[start as usize..end as usize]
                        .sort_by(|(a, _), (b, _)| a.partial_cmp(b).expect("numbers are not NaN"));
                }
                start = end;
            }
        }
    }
}

/// How many numbers are handled at once.
const FOUR: usize = 4;

/// The least and the greatest of the finite numbers. Infinite ones must not spoil the guess.
#[inline]
fn range<R: Real>(numbers: impl Iterator<Item = R> + Clone) -> [R; 2] {
    fn widest<R: Real>(mut numbers: impl Iterator<Item = R>) -> [R; 2] {
        let less = |a: R, b: R| if a < b { a } else { b };
        let more = |a: R, b: R| if a > b { a } else { b };
        // In four rows: in one, each comparison would wait for the last.
        let mut lows = [R::MAX; FOUR];
        let mut highs = [R::ZERO - R::MAX; FOUR];
        'all: loop {
            for k in 0..FOUR {
                let Some(x) = numbers.next() else {
                    break 'all;
                };
                (lows[k], highs[k]) = (less(x, lows[k]), more(x, highs[k]));
            }
        }
        let low = lows.into_iter().reduce(less);
        let high = highs.into_iter().reduce(more);
        [low, high].map(|x| x.expect("four rows"))
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
