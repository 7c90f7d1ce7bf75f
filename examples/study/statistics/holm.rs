//! Holm's correction: with many tests, some are small by chance.

/// The adjusted p-values, in the order of the given ones: if all below a level are taken for real, the chance that any of them
/// is not is at most that level. They count as so many tests at least.
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

#[cfg(test)]
mod tests {
    use super::holm;

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
}
