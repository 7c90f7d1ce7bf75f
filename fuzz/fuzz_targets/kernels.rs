//! Every kernel against the oracle, on boxes decoded from bytes.

#![no_main]

#[path = "../../tests/oracle/fuzzed.rs"]
mod fuzzed;
#[path = "../../tests/oracle/numbers.rs"]
mod numbers;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzzed::check(bytes));
