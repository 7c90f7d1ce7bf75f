//! Runs a test on many sequences and shows the shortest that fails.

use proptest::test_runner::{Config, TestRunner};

use crate::ops::Sequence;
use crate::strategies::sequences;

/// Sequences per test, unless `PROPTEST_CASES` says otherwise.
const CASES: u32 = 64;

pub(crate) fn check(play: impl Fn(&Sequence)) {
    let mut config = Config {
        failure_persistence: None,
        ..Config::default()
    };
    if std::env::var_os("PROPTEST_CASES").is_none() {
        config.cases = CASES;
    }
    let outcome = TestRunner::new(config).run(&sequences(), |sequence| {
        play(&sequence);
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}
