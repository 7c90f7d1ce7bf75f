//! Checks random values, by proptest.

use proptest::strategy::Strategy;
use proptest::test_runner::{Config, TestRunner};

use crate::cases::cases;

/// Checks `usual` random values, or as many as `PROPTEST_CASES` says. Panics with the simplest value that fails.
pub(crate) fn check<S: Strategy>(usual: u32, values: &S, check: impl Fn(&S::Value)) {
    let config = Config {
        failure_persistence: None,
        // The default is four per case.
        max_shrink_iters: 2_000,
        ..Config::with_cases(cases(usual))
    };
    let outcome = TestRunner::new(config).run(values, |value| {
        check(&value);
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}
