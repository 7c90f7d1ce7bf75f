//! The test of the fuzzer, on random bytes and on the inputs that it has kept.

use proptest::collection::vec;
use proptest::prelude::any;

use crate::fuzzed;
use crate::random_values;

#[path = "../../fuzz/corpus.rs"]
mod corpus;

#[test]
fn random_bytes_pass() {
    random_values::check(2000, &vec(any::<u8>(), 0..1500), |bytes| {
        fuzzed::check(bytes)
    });
}

#[test]
fn inputs_of_the_fuzzer_pass() {
    corpus::replay("kernels", fuzzed::check);
}
