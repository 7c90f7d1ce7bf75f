//! Quantiles.

/// The smallest of the values that at least this share of them does not exceed; none if there are none. Reorders them.
/// **O(n)**.
pub(crate) fn quantile(values: &mut [f32], share: f64) -> Option<f32> {
    let last = values.len().checked_sub(1)?;
    // A share such as 0.07 of 100 is a little more than 7 in floating-point numbers.
    let rank = (share * values.len() as f64 - 1e-9).ceil() as usize;
    let index = rank.saturating_sub(1).min(last);
    Some(*values.select_nth_unstable_by(index, f32::total_cmp).1)
}

#[cfg(test)]
mod tests {
    use super::quantile;

    #[test]
    fn quantiles_are_values_of_their_rank() {
        // 1 to 100 in another order.
        let values = || -> Vec<f32> { (0..100_u16).map(|i| f32::from(i * 37 % 100 + 1)).collect() };
        for (share, expected) in [
            (0.0, 1.0),
            (0.07, 7.0),
            (0.5, 50.0),
            (0.75, 75.0),
            (0.9, 90.0),
            (0.99, 99.0),
            (0.995, 100.0),
            (1.0, 100.0),
        ] {
            assert_eq!(quantile(&mut values(), share), Some(expected));
        }
        assert_eq!(quantile(&mut [3.0], 0.5), Some(3.0));
        assert_eq!(quantile(&mut [], 0.5), None);
    }
}
