//! A share of trials, with the interval in which that of the ensemble is.

use serde::Serialize;
use statrs::distribution::{Beta, ContinuousCDF};

/// How sure the interval is, at least.
const CONFIDENCE: f64 = 0.95;

/// How many of all trials came out in one way, with the exact interval of Clopper and Pearson.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Share {
    pub(crate) count: usize,
    pub(crate) all: usize,
    pub(crate) low: f64,
    pub(crate) high: f64,
}

impl Share {
    /// The share of so many trials.
    ///
    /// Where none came out so, or all, there is one bound to be sure of: after n trials without a failure, failures are rarer than
    /// about 3 / n (the rule of three).
    pub(crate) fn of(count: usize, all: usize) -> Self {
        let tail = match count == 0 || count == all {
            true => 1.0 - CONFIDENCE,
            false => (1.0 - CONFIDENCE) / 2.0,
        };
        let quantile = |a: usize, b: usize, p: f64| {
            let beta = Beta::new(a as f64, b as f64).expect("both are positive");
            beta.inverse_cdf(p)
        };
        Self {
            count,
            all,
            low: match count {
                0 => 0.0,
                _ => quantile(count, all - count + 1, tail),
            },
            high: match count == all {
                true => 1.0,
                false => quantile(count + 1, all - count, 1.0 - tail),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Share;

    #[test]
    fn bounds_are_those_of_the_tables() {
        for (count, all, low, high) in [
            (0, 30, 0.0, 0.0950),
            (0, 300, 0.0, 0.00994),
            (30, 30, 0.9050, 1.0),
            (5, 10, 0.1871, 0.8129),
            (1, 25, 0.0010, 0.2035),
            (0, 0, 0.0, 1.0),
        ] {
            let share = Share::of(count, all);
            assert!((share.low - low).abs() < 1e-4, "{share:?}");
            assert!((share.high - high).abs() < 1e-4, "{share:?}");
        }
    }
}
