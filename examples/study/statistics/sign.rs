//! The exact sign test: does one fail more often than the other?

use statrs::distribution::{Binomial, DiscreteCDF};

/// How probable it is that so many or more fall on one side, of those that fall on either, if each is as probable as the other.
pub(crate) fn sign_test(one: usize, other: usize) -> f64 {
    match (Binomial::new(0.5, (one + other) as u64), one.checked_sub(1)) {
        (Ok(on_one), Some(fewer)) => on_one.sf(fewer as u64),
        _ => 1.0,
    }
}

#[cfg(test)]
mod tests {
    use super::sign_test;

    #[test]
    fn probabilities_are_those_of_coins() {
        for (one, other, expected) in [
            (0, 0, 1.0),
            (0, 5, 1.0),
            (1, 0, 0.5),
            (1, 1, 0.75),
            (10, 0, 1.0 / 1024.0),
            (9, 1, 11.0 / 1024.0),
        ] {
            let p = sign_test(one, other);
            assert!((p - expected).abs() < 1e-9, "{one} {other}: {p}");
        }
    }
}
