//! The middle of a sample.

/// The median; NaN of an empty sample.
pub(crate) fn median(sample: impl IntoIterator<Item = f64>) -> f64 {
    let mut sorted: Vec<_> = sample.into_iter().collect();
    sorted.sort_by(f64::total_cmp);
    match sorted.len() {
        0 => f64::NAN,
        // Halved first, and one alone where both are infinite.
        count => sorted[(count - 1) / 2] / 2.0 + sorted[count / 2] / 2.0,
    }
}

/// The geometric mean of ratios.
pub(crate) fn geometric_mean(ratios: &[f64]) -> f64 {
    let logarithms = ratios.iter().map(|ratio| ratio.ln());
    (logarithms.sum::<f64>() / ratios.len() as f64).exp()
}

#[cfg(test)]
mod tests {
    use super::{geometric_mean, median};

    #[test]
    fn the_middle_is_between_the_two() {
        assert_eq!(median([3.0, 1.0, 2.0]), 2.0);
        assert_eq!(median([4.0, 1.0, 2.0, f64::INFINITY]), 3.0);
        assert!(median([]).is_nan());
        assert!((geometric_mean(&[0.5, 8.0]) - 2.0).abs() < 1e-12);
    }
}
