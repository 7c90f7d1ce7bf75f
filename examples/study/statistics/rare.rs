//! How rare is what has not happened?

/// How sure the bound is.
const CONFIDENCE: f64 = 0.95;

/// The most that the share of failures may be after so many trials without one: about 3 / n, the rule of three. Clopper and Pearson's
/// exact bound.
pub(crate) fn rarer_than(trials: usize) -> f64 {
    1.0 - (1.0 - CONFIDENCE).powf(1.0 / trials as f64)
}

#[cfg(test)]
mod tests {
    use super::rarer_than;

    #[test]
    fn bounds_are_those_of_the_tables() {
        for (trials, bound) in [(0, 1.0), (30, 0.0950), (300, 0.00994)] {
            let found = rarer_than(trials);
            assert!((found - bound).abs() < 1e-4, "{trials}: {found}");
        }
    }
}
