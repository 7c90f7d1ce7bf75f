//! The broad phase over time against a model, on sequences decoded from bytes.

#![no_main]

#[path = "../../tests/sequences/flavours.rs"]
mod flavours;
#[path = "../../tests/sequences/fuzzed.rs"]
mod fuzzed;
#[path = "../../tests/sequences/ops.rs"]
mod ops;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzzed::play(bytes));
