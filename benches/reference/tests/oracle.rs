//! Sweep and prune passes the tests of every kernel.

#[allow(dead_code, unreachable_pub, unused_imports)] // The crate of scenes publishes all of it.
#[path = "../../../tests/common/boxes/mod.rs"]
mod arrangements;
#[path = "../../../tests/oracle/boxes.rs"]
mod boxes;
#[path = "../../../tests/oracle/check.rs"]
mod check;
#[path = "../../../tests/oracle/errors.rs"]
mod errors;
#[path = "../../../tests/oracle/inputs.rs"]
mod inputs;
#[path = "../../../tests/oracle/limits.rs"]
mod limits;
#[allow(dead_code)] // The fuzzer has numbers of its own.
#[path = "../../../tests/oracle/numbers.rs"]
mod numbers;
#[path = "../../../tests/oracle/random.rs"]
mod random;

use numbers::Number;
use unisize_reference::SweepAndPrune;

fn pass<R: Number, const D: usize>()
where
    SweepAndPrune<R, D>: Default + Clone,
{
    check::every::<SweepAndPrune<R, D>, R, D>(&inputs::all());
    errors::check::<SweepAndPrune<R, D>, R, D>();
}

#[test]
fn single_precision() {
    pass::<f32, 1>();
    pass::<f32, 2>();
    pass::<f32, 3>();
}

#[test]
fn double_precision() {
    pass::<f64, 2>();
    pass::<f64, 3>();
    pass::<f64, 4>();
}
