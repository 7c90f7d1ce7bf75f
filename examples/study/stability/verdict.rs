//! Who fails in a case: neither, both alike, or one alone, by one rule for all cases.
//!
//! A world near its limit is chaotic: the last bit of a number decides whether it holds, and the order of events decides the last
//! bit. So each case is run from several starts on either broad phase, and failures are counted. *Alone* means that one has so many
//! more that Fisher's exact test would find it by chance in less than one of a hundred whole runs of this program: the
//! probability, one-sided, times the number of cases and of sides (Bonferroni), is below 1 %.

use serde::Serialize;
use statrs::stats_tests::{Alternative, fisher::fishers_exact};

/// How many runs failed, and of how many.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub(crate) struct Failures {
    pub(crate) failed: usize,
    pub(crate) runs: usize,
}

/// Who fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Verdict {
    /// No run failed.
    Neither,
    /// Both, or one a little more often than the other: the solver, the time step or the number format fails.
    Alike,
    /// Rapier's own broad phase, significantly more often.
    DefaultAlone,
    /// unisize, significantly more often.
    OursAlone,
}

/// The probability of a wrong "alone" in a whole run of the program, and of a wrong "more often" in all cases together.
pub(crate) const LEVEL: f64 = 0.01;

impl Verdict {
    /// The verdict on one of so many cases.
    pub(crate) fn of(default: Failures, ours: Failures, cases: usize) -> Self {
        let is_significant = |more, less| is_told(more, less, cases);
        if default.failed + ours.failed == 0 {
            Self::Neither
        } else if is_significant(ours, default) {
            Self::OursAlone
        } else if is_significant(default, ours) {
            Self::DefaultAlone
        } else {
            Self::Alike
        }
    }
}

/// Whether so many more failures on one side are significant in one of so many cases.
fn is_told(more: Failures, less: Failures, cases: usize) -> bool {
    let tests = 2.0 * cases as f64;
    probability(more, less) * tests < LEVEL
}

/// How probable it is that of all these failures so many or more fall on `more`, if both fail equally often.
fn probability(more: Failures, less: Failures) -> f64 {
    let table = [more, less].map(|f| [f.failed as u64, (f.runs - f.failed) as u64]);
    let [[a, b], [c, d]] = table;
    // Without runs there is nothing to find.
    fishers_exact(&[a, b, c, d], Alternative::Greater).unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::{Failures, Verdict, probability};

    fn of(failed: usize, runs: usize) -> Failures {
        Failures { failed, runs }
    }

    #[test]
    fn probabilities_are_those_of_fisher() {
        // All tables of nine failures among 18 runs: one of 48,620 has all on one side.
        let p = probability(of(9, 9), of(0, 9));
        assert!((p * 48_620.0 - 1.0).abs() < 1e-6, "{p}");
        // The lady who tells three of four cups: 17 of 70.
        let p = probability(of(3, 4), of(1, 4));
        assert!((p - 17.0 / 70.0).abs() < 1e-9, "{p}");
        assert!(probability(of(0, 9), of(9, 9)) > 0.999);
    }

    #[test]
    fn alone_means_far_more_often() {
        let cases = 120;
        for (default, ours, verdict) in [
            (0, 0, Verdict::Neither),
            (9, 9, Verdict::Alike),
            (4, 6, Verdict::Alike),
            (0, 3, Verdict::Alike),
            (0, 9, Verdict::OursAlone),
            (9, 0, Verdict::DefaultAlone),
        ] {
            assert_eq!(Verdict::of(of(default, 9), of(ours, 9), cases), verdict);
        }
        // The more cases, the more is a matter of chance.
        assert_eq!(Verdict::of(of(0, 9), of(9, 9), 100_000), Verdict::Alike);
        assert_eq!(Verdict::of(of(0, 0), of(0, 0), 1), Verdict::Neither);
    }
}
