//! The median of a sample, with the interval in which that of the ensemble is, by the order of the sample alone.

use serde::Serialize;
use statrs::distribution::{Binomial, DiscreteCDF};

/// How sure the interval is, at least.
const CONFIDENCE: f64 = 0.95;

/// A median and its interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Median {
    pub(crate) value: f64,
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Median {
    /// The median of a sample that is not empty.
    ///
    /// The interval is between two of the sorted values, as many from either end. The median of the ensemble is below the
    /// k-th smallest one only if fewer than k of n values are below it, each with a chance of one half. A sample of fewer than
    /// six is too small for an interval of 95 %: then it is the whole range.
    pub(crate) fn of(sample: impl IntoIterator<Item = f64>) -> Self {
        let mut sorted: Vec<_> = sample.into_iter().collect();
        sorted.sort_by(f64::total_cmp);
        let count = sorted.len();
        let middle = [(count - 1) / 2, count / 2].map(|index| sorted[index]);
        let cut = cut(count);
        Self {
            // Halved first, and one alone where both are infinite.
            value: middle[0] / 2.0 + middle[1] / 2.0,
            low: sorted[cut],
            high: sorted[count - 1 - cut],
        }
    }
}

/// How many values are outside of the interval at either end.
fn cut(count: usize) -> usize {
    let below = Binomial::new(0.5, count as u64).expect("one half is a probability");
    let is_sure = |cut: &usize| 2.0 * below.cdf(*cut as u64) <= 1.0 - CONFIDENCE;
    (0..count / 2).take_while(is_sure).last().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::{Median, cut};
    use oorandom::Rand32;

    #[test]
    fn the_interval_is_that_of_the_tables() {
        // The usual table for 95 %: of 20 values, from the sixth to the fifteenth.
        for (count, rank) in [(6, 1), (10, 2), (15, 4), (20, 6), (30, 10), (50, 18)] {
            assert_eq!(cut(count), rank - 1, "{count}");
        }
        let median = Median::of((1..=20).map(f64::from).rev());
        assert_eq!((median.low, median.value, median.high), (6.0, 10.5, 15.0));
        let single = Median::of([3.0]);
        assert_eq!((single.low, single.value, single.high), (3.0, 3.0, 3.0));
    }

    #[test]
    fn the_interval_holds_the_median_as_often_as_it_says() {
        let mut random = Rand32::new(1);
        let trials = 4000;
        let hits = (0..trials).filter(|_| {
            let median = Median::of((0..20).map(|_| f64::from(random.rand_float())));
            median.low <= 0.5 && 0.5 <= median.high
        });
        // 0.9586 by the formula; three standard errors are 0.0095.
        let share = hits.count() as f64 / f64::from(trials);
        assert!((0.949..0.969).contains(&share), "{share}");
    }
}
