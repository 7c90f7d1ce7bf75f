//! How many cases a random test tries.

/// This many, unless `PROPTEST_CASES` says otherwise.
pub(crate) fn cases(usual: u32) -> u32 {
    let cases = std::env::var("PROPTEST_CASES").map(|cases| cases.parse());
    cases.map_or(usual, |cases| cases.expect("PROPTEST_CASES is a number"))
}
