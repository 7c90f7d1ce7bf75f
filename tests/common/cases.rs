//! The number of cases of a random test.

/// `PROPTEST_CASES` if it is set, else `usual`.
pub(crate) fn cases(usual: u32) -> u32 {
    let cases = std::env::var("PROPTEST_CASES").map(|cases| cases.parse());
    cases.map_or(usual, |cases| cases.expect("PROPTEST_CASES is a number"))
}
