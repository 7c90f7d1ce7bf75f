//! Statistics of samples: medians, bounds of shares, tests of two samples or of two methods on the same starts, and the correction for
//! many tests.

use oorandom::Rand64;
use statrs::distribution::{Binomial, ContinuousCDF, DiscreteCDF, Normal};
use statrs::statistics::{Data, OrderStatistics, Statistics};

/// The confidence of a [bound](rarer_than).
const CONFIDENCE: f64 = 0.95;

/// The number of random exchanges of outcomes.
const EXCHANGES: u32 = 100_000;

/// The median; NaN of an empty sample.
pub(crate) fn median(sample: impl IntoIterator<Item = f64>) -> f64 {
    Data::new(sample.into_iter().collect::<Vec<_>>()).median()
}

/// The geometric mean of ratios.
pub(crate) fn geometric_mean(ratios: &[f64]) -> f64 {
    ratios.geometric_mean()
}

/// The upper bound of the share of failures after this many trials without one: about 3 / n, the rule of three. It is Clopper and
/// Pearson's exact bound.
pub(crate) fn rarer_than(trials: usize) -> f64 {
    1.0 - (1.0 - CONFIDENCE).powf(1.0 / trials as f64)
}

/// The p-value of the exact one-sided sign test: how probable it is that this many or more fall on one side if both sides are equally
/// probable.
pub(crate) fn sign_test(one: usize, other: usize) -> f64 {
    match (Binomial::new(0.5, (one + other) as u64), one.checked_sub(1)) {
        (Ok(on_one), Some(fewer)) => on_one.sf(fewer as u64),
        _ => 1.0,
    }
}

/// The p-value of the two-sided rank-sum test of Wilcoxon, Mann and Whitney: how probable it is that two samples of one distribution
/// differ by so much in their ranks. It is the normal approximation with corrections for ties and for continuity, which holds from
/// some eight values on each side on.
pub(crate) fn rank_sum_test(first: &[f64], second: &[f64]) -> f64 {
    let [m, n] = [first, second].map(|sample| sample.len() as f64);
    let count = |sample: &[f64], is_so: &dyn Fn(f64) -> bool| {
        sample.iter().filter(|&&x| is_so(x)).count() as f64
    };
    let below = |x: f64| count(second, &|y| y < x) + count(second, &|y| y == x) / 2.0;
    let u: f64 = first.iter().map(|&x| below(x)).sum();
    // Each value adds the square of its ties less one, so that t equal values add t³ - t.
    let both = || first.iter().chain(second);
    let ties = |&x: &f64| (count(first, &|y| y == x) + count(second, &|y| y == x)).powi(2) - 1.0;
    let ties: f64 = both().map(ties).sum();
    let variance = m * n / 12.0 * (m + n + 1.0 - ties / ((m + n) * (m + n - 1.0)));
    let distance = ((u - m * n / 2.0).abs() - 0.5).max(0.0);
    match Normal::new(0.0, variance.sqrt()) {
        Ok(normal) => 2.0 * normal.sf(distance),
        // All values are equal, or there are none.
        Err(_) => 1.0,
    }
}

/// Holm's correction, since some p-values of many tests are small by chance. Returns the adjusted p-values in the order of the given ones:
/// if all below a level are rejected, the probability of a false rejection is at most that level. They count as at least this many tests.
///
/// Holm, "A simple sequentially rejective multiple test procedure", 1979. Tests may depend on each other in any way.
pub(crate) fn holm(p_values: &[f64], tests: usize) -> Vec<f64> {
    let mut order: Vec<_> = (0..p_values.len()).collect();
    order.sort_by(|&a, &b| p_values[a].total_cmp(&p_values[b]));
    let mut adjusted = vec![0.0; p_values.len()];
    let mut largest = 0.0_f64;
    for (rank, index) in order.into_iter().enumerate() {
        let left = (p_values.len().max(tests) - rank) as f64;
        largest = largest.max((p_values[index] * left).min(1.0));
        adjusted[index] = largest;
    }
    adjusted
}

/// The two-sided p-value of a permutation test of whether two methods differ in accuracy. The errors are by time step, then by seed; they
/// may be infinite, but not NaN. The smallest possible value is one in 100,001.
///
/// Each seed is simulated with both methods and all time steps. If the methods do not differ, their outcomes of a seed can be exchanged. So
/// the test exchanges them at random, very often, and counts how often the two then differ as much as observed. It compares signed ranks,
/// as in the test of Wilcoxon, so that one error that is a thousand times as large as all others does not decide alone. Ranks are within a
/// time step, and a seed is exchanged with all its time steps at once, since they have the start in common.
///
/// The test detects that one method is worse over all time steps. It does **not** detect an effect that changes its sign with the time
/// step, since ranks of opposite signs cancel, nor a change of the spread alone, with as many runs better as worse.
pub(crate) fn paired_test(first: &[Vec<f64>], second: &[Vec<f64>]) -> f64 {
    let scores = scores(first, second);
    let all: f64 = scores.iter().sum();
    let mut random = Rand64::new(1);
    let mut as_far = 0;
    for _ in 0..EXCHANGES {
        let mut sum = 0.0;
        for scores in scores.chunks(64) {
            let mut signs = random.rand_u64();
            for score in scores {
                sum += if signs & 1 == 0 { *score } else { -score };
                signs >>= 1;
            }
        }
        // Ranks are halves, so that sums are exact.
        as_far += u32::from(f64::abs(sum) >= all.abs());
    }
    f64::from(as_far + 1) / f64::from(EXCHANGES + 1)
}

/// The sum of the signed ranks over all time steps, for each seed. It is positive where the second method is worse.
fn scores(first: &[Vec<f64>], second: &[Vec<f64>]) -> Vec<f64> {
    let seeds = first.first().map_or(0, Vec::len);
    let mut scores = vec![0.0; seeds];
    for (first, second) in first.iter().zip(second) {
        let differences: Vec<_> = first
            .iter()
            .zip(second)
            .map(|(a, b)| difference(*a, *b))
            .collect();
        for (score, difference) in scores.iter_mut().zip(&differences) {
            let below = |x: &&f64| **x != 0.0 && x.abs() < difference.abs();
            let equal = |x: &&f64| x.abs() == difference.abs();
            let below = differences.iter().filter(below).count();
            let equal = differences.iter().filter(equal).count();
            if *difference != 0.0 {
                // The mean rank of those that are equal.
                let rank = below as f64 + (equal + 1) as f64 / 2.0;
                *score += rank * difference.signum();
            }
        }
    }
    scores
}

/// The difference of two errors that may both be infinite.
fn difference(first: f64, second: f64) -> f64 {
    if first == second { 0.0 } else { second - first }
}

#[cfg(test)]
mod tests {
    use super::*;
    use oorandom::Rand32;

    /// Errors of 20 seeds with 2 time steps, the second of which halves them; seeds differ by a factor of ten.
    fn ensemble(random: &mut Rand32, factor: f64) -> Vec<Vec<f64>> {
        let mut error = |scale: f64, seed: u32| {
            let noise = 1.0 + 0.2 * f64::from(random.rand_float());
            factor * scale * noise * f64::from(seed) / 2.0
        };
        let of_step = [1.0, 0.5].map(|scale| (1..=20).map(|seed| error(scale, seed)).collect());
        of_step.into()
    }

    #[test]
    fn adjusted_as_in_the_textbook() {
        assert!(holm(&[], 3).is_empty());
        let close = |a: &[f64], b: &[f64]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        // 0.005 x 4; 0.01 x 3; 0.03 x 2; 0.04 x 1, which may not be less than the one before.
        let adjusted = holm(&[0.01, 0.04, 0.03, 0.005], 0);
        assert!(close(&adjusted, &[0.03, 0.06, 0.06, 0.02]), "{adjusted:?}");
        assert!(close(&holm(&[0.5, 0.9], 1), &[1.0, 1.0]));
        assert!(close(&holm(&[0.01, 0.02], 10), &[0.1, 0.18]));
    }

    #[test]
    fn bounds_and_probabilities_are_those_of_the_tables() {
        for (trials, bound) in [(0, 1.0), (30, 0.0950), (300, 0.00994)] {
            assert!((rarer_than(trials) - bound).abs() < 1e-4, "{trials}");
        }
        let coins = [(0, 0, 1.0), (0, 5, 1.0), (1, 0, 0.5), (1, 1, 0.75)];
        let tens = [(10, 0, 1.0 / 1024.0), (9, 1, 11.0 / 1024.0)];
        for (one, other, expected) in coins.into_iter().chain(tens) {
            let p = sign_test(one, other);
            assert!((p - expected).abs() < 1e-9, "{one} {other}: {p}");
        }
    }

    #[test]
    fn the_rank_sum_test_has_the_values_of_the_textbook() {
        let (first, second) = ([19.0, 22.0, 16.0, 29.0, 24.0], [20.0, 11.0, 17.0, 12.0]);
        let p = rank_sum_test(&first, &second);
        assert!((p - 0.111_346_886).abs() < 1e-6, "{p}");
        assert_eq!(p, rank_sum_test(&second, &first));
        let p = rank_sum_test(&[1.0, 2.0, 2.0, 3.0, 5.0], &[2.0, 4.0, 4.0, 6.0, 7.0]);
        assert!((p - 0.137_563_894).abs() < 1e-6, "{p}");
        assert_eq!(rank_sum_test(&[1.0; 3], &[1.0; 4]), 1.0);
        assert_eq!(rank_sum_test(&[], &[]), 1.0);
    }

    #[test]
    fn infinite_errors_have_a_median() {
        assert!(median([]).is_nan());
        assert_eq!(median([4.0, 1.0, 2.0, f64::INFINITY]), 3.0);
        assert_eq!(median([1.0, f64::INFINITY, f64::INFINITY]), f64::INFINITY);
    }

    #[test]
    fn ranks_are_signed_and_shared_by_equals() {
        let ranks = scores(&[vec![1.0, 2.0, 3.0, 4.0]], &[vec![2.0, 1.0, 3.0, 9.0]]);
        assert_eq!(ranks, [1.5, -1.5, 0.0, 3.0]);
        let infinite = f64::INFINITY;
        let none = scores(&[vec![infinite, 1.0]], &[vec![infinite, infinite]]);
        assert_eq!(none, [0.0, 1.0]);
    }

    #[test]
    fn what_differs_is_told_apart_and_what_is_equal_is_not() {
        let p = paired_test(&[vec![0.0; 5]], &[vec![1.0, 2.0, 3.0, 4.0, 5.0]]);
        assert!((p - 1.0 / 16.0).abs() < 0.004, "five of five: {p}");
        // A third is noticed, though seeds differ by a factor.
        let mut random = Rand32::new(2);
        let first = ensemble(&mut random, 1.0);
        assert_eq!(paired_test(&first, &first), 1.0);
        let worse = ensemble(&mut random, 1.3);
        let p = paired_test(&first, &worse);
        assert!(p < 10.0 / f64::from(EXCHANGES), "{p}");
        assert_eq!(p, paired_test(&worse, &first));
    }

    #[test]
    fn alike_ones_are_told_apart_as_seldom_as_the_level_says() {
        let mut random = Rand32::new(3);
        let told_apart = (0..200).filter(|_| {
            let first = ensemble(&mut random, 1.0);
            paired_test(&first, &ensemble(&mut random, 1.0)) < 0.1
        });
        // Twenty are expected; three standard errors are 13.
        let count = told_apart.count();
        assert!((7..=33).contains(&count), "{count}");
    }
}
