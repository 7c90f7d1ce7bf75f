//! The test whether two methods differ in accuracy: on the same starts, by exchanging their outcomes.
//!
//! Each seed is simulated with both methods and all time steps. If it makes no difference which of two methods is which, their
//! outcomes of a seed can be exchanged. So the test exchanges them at random, very often, and counts how often the two then seem
//! to differ as much as they do. What is compared are signed ranks, as in the test of Wilcoxon: one error that is a thousand times
//! as large as all others must not decide alone. Ranks are within a time step, and a seed is exchanged with all its time steps at
//! once, since they have the start in common.
//!
//! The test sees that one is worse on the whole, over all time steps. It does **not** see an effect that changes its sign with the
//! time step, as ranks of opposite signs cancel, nor a change of the spread alone, with as many runs better as worse.

use oorandom::Rand64;

/// How often outcomes are exchanged at random.
const EXCHANGES: u32 = 100_000;

/// The chance that two methods alike differ by so much, in either direction. The errors are by time step, then by seed; they may be
/// infinite, but must be numbers.
///
/// The smallest possible value is one in 100,001.
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

/// By how much the second is worse, for each seed: the sum of its signed ranks over all time steps.
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
    use super::{EXCHANGES, paired_test, scores};
    use oorandom::Rand32;

    /// Errors of 20 seeds with 2 time steps, the second of which halves them; seeds differ by a factor of ten.
    fn ensemble(random: &mut Rand32, factor: f64) -> Vec<Vec<f64>> {
        [1.0, 0.5]
            .map(|scale| {
                let seeds = 1..=20;
                seeds
                    .map(|seed| {
                        let noise = 1.0 + 0.2 * f64::from(random.rand_float());
                        factor * scale * noise * f64::from(seed) / 2.0
                    })
                    .collect()
            })
            .into()
    }

    #[test]
    fn ranks_are_signed_and_shared_by_equals() {
        let scores = scores(&[vec![1.0, 2.0, 3.0, 4.0]], &[vec![2.0, 1.0, 3.0, 9.0]]);
        assert_eq!(scores, [1.5, -1.5, 0.0, 3.0]);
        let infinite = f64::INFINITY;
        let none = super::scores(&[vec![infinite, 1.0]], &[vec![infinite, infinite]]);
        assert_eq!(none, [0.0, 1.0]);
    }

    #[test]
    fn equal_samples_cannot_be_told_apart() {
        let sample = ensemble(&mut Rand32::new(1), 1.0);
        assert_eq!(paired_test(&sample, &sample), 1.0);
    }

    #[test]
    fn five_of_five_are_one_in_sixteen() {
        let p = paired_test(&[vec![0.0; 5]], &[vec![1.0, 2.0, 3.0, 4.0, 5.0]]);
        assert!((p - 1.0 / 16.0).abs() < 0.004, "{p}");
    }

    #[test]
    fn a_third_is_noticed_though_seeds_differ_by_a_factor() {
        let mut random = Rand32::new(2);
        let first = ensemble(&mut random, 1.0);
        let worse = ensemble(&mut random, 1.3);
        let p = paired_test(&first, &worse);
        assert!(p < 10.0 / f64::from(EXCHANGES), "{p}");
        assert_eq!(p, paired_test(&worse, &first));
    }

    #[test]
    fn alike_ones_are_told_apart_as_seldom_as_the_level_says() {
        let mut random = Rand32::new(3);
        let trials = 200;
        let told_apart = (0..trials).filter(|_| {
            let first = ensemble(&mut random, 1.0);
            paired_test(&first, &ensemble(&mut random, 1.0)) < 0.1
        });
        // Twenty are expected; three standard errors are 13.
        let count = told_apart.count();
        assert!((7..=33).contains(&count), "{count}");
    }
}
