//! Replays the inputs that the fuzzer has kept.

use crate::fuzzed;

#[path = "../../fuzz/corpus.rs"]
mod corpus;

#[test]
fn inputs_of_the_fuzzer() {
    corpus::replay("updates", fuzzed::play);
}
