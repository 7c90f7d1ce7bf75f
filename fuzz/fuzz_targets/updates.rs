//! The broad phase over time against a model, on sequences from bytes.

#![no_main]

#[path = "../../tests/sequences/dim2.rs"]
mod dim2;
#[path = "../../tests/sequences/dim2_0_36.rs"]
mod dim2_0_36;
#[path = "../../tests/sequences/dim2_f64.rs"]
mod dim2_f64;
#[path = "../../tests/sequences/dim3.rs"]
mod dim3;
#[path = "../../tests/sequences/dim3_0_36.rs"]
mod dim3_0_36;
#[path = "../../tests/sequences/dim3_f64.rs"]
mod dim3_f64;
#[path = "../../tests/sequences/fuzzed.rs"]
mod fuzzed;
#[path = "../../tests/sequences/ops.rs"]
mod ops;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| fuzzed::play(bytes));
