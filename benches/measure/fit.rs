//! Prices of units, from what whole updates took.

use crate::prices::{UNITS, Work};

/// Passes over the prices; each sets every price to the best one, given the others.
const PASSES: usize = 2000;

/// The prices, none below zero, by which the relative errors of these times, in ns, have the least squares.
pub(crate) fn prices(samples: impl Iterator<Item = (Work, f64)>) -> Work {
    let units = Work::default().len();
    let mut products = [[0.0; UNITS.len()]; UNITS.len()];
    let mut sums = Work::default();
    for (work, time) in samples {
        let relative = work.map(|count| count / time);
        for i in 0..units {
            sums[i] += relative[i];
            for j in 0..units {
                products[i][j] += relative[i] * relative[j];
            }
        }
    }
    let mut prices = Work::default();
    for _ in 0..PASSES {
        for i in 0..units {
            let others: f64 = (0..units)
                .filter(|&j| j != i)
                .map(|j| products[i][j] * prices[j])
                .sum();
            if products[i][i] > 0.0 {
                prices[i] = ((sums[i] - others) / products[i][i]).max(0.0);
            }
        }
    }
    prices
}
