//! A stable sort of a few numbers that are spread about evenly.
//!
//! A linear guess puts the numbers into twice as many buckets as there are numbers. About one in eight is then out of place, and
//! insertion moves it. Numbers and buckets should fit in the first or second level of cache.

use crate::aabb::{max, min};
use crate::counting_sort::{starts_from_counts, take_place};
use crate::lanes::Lanes;
use crate::real::Real;
use crate::tuning::kernel::{BUCKETS_AN_ENTRY, CROWDED_BUCKET, INSERTION_UP_TO};

/// The scratch memory of the sort.
#[derive(Clone, Debug, Default)]
pub(crate) struct BucketSort<R> {
    /// The numbers and their positions.
    sorted: Vec<(R, u32)>,
    /// The bucket of each number.
    buckets: Vec<u32>,
    /// By bucket: how many numbers it has, then the place of its next number.
    cursors: Vec<u32>,
}

impl<R: Real> BucketSort<R> {
    /// Returns the numbers with their positions, ascending; equal numbers by position. No number may be NaN.
    ///
    /// Computes in **O(n)** time if the numbers are spread evenly, and in **O(n log n)** otherwise.
    #[inline]
    pub(crate) fn sort(
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

    /// Brings the numbers nearly into order, by a stable counting sort into ascending buckets.
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
        // Non-decreasing in the numbers, as the strips of a grid are. If some are infinite, all have one bucket.
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
        // Every place is written below.
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

/// The least and the greatest number.
#[inline]
fn range<R: Real>(mut numbers: impl Iterator<Item = R>) -> [R; 2] {
    // In one row, each comparison would wait for the last.
    let mut rows = [[R::INFINITY, R::NEG_INFINITY]; FOUR];
    'all: loop {
        for [low, high] in &mut rows {
            let Some(x) = numbers.next() else {
                break 'all;
            };
            (*low, *high) = (min(x, *low), max(x, *high));
        }
    }
    let range = rows
        .into_iter()
        .reduce(|a, b| [min(a[0], b[0]), max(a[1], b[1])]);
    range.expect("there are four rows")
}

/// Sorts by insertion: fast if few numbers are far from their place. Stable.
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
