//! Every kernel against the oracle: one suite, written once, one line per kernel, scalar and dimension.
//!
//! Inputs have names (`inputs`, and `limits`, made of the lists of `boxes`), so a failure says which kind of scene went wrong.
//! `check` lists what must hold for every input, and `errors` for inputs that must be refused. `fuzzed` is what the fuzzer runs, and
//! `replay` runs it on random bytes, for more of which raise `PROPTEST_CASES`, and on the inputs that the fuzzer has kept.

mod boxes;
mod check;
mod effort;
mod errors;
mod fuzzed;
mod inputs;
mod limits;
mod numbers;
mod random;
mod replay;
mod slabs;
mod timed;

#[allow(dead_code, unreachable_pub)] // The laboratory's crate of scenes publishes all of it.
#[path = "../common/boxes/mod.rs"]
mod arrangements;
#[path = "../common/cases.rs"]
mod cases;
#[path = "../common/random_values.rs"]
mod random_values;

use slabs::InSlabs;
use unisize::{BruteForce, GridSweep, RankSweep};

/// Instantiates the suite for one kernel: the module's name, the kernel, its scalar and its dimension.
macro_rules! oracle_suite {
    ($name:ident, $finder:ty, $real:ty, $dim:literal) => {
        mod $name {
            use super::*;

            #[test]
            fn named_inputs() {
                check::every::<$finder, $real, $dim>(&inputs::all());
            }

            #[test]
            fn invalid_inputs_are_refused() {
                errors::check::<$finder, $real, $dim>();
            }
        }
    };
}

/// The suite for a kernel in two and three dimensions and both scalars, and for whatever else is named.
macro_rules! suites {
    ($name:ident, $finder:ident $(, $more:ident $real:ty, $dim:literal)*) => {
        mod $name {
            use super::*;

            oracle_suite!(f32_2, $finder<f32, 2>, f32, 2);
            oracle_suite!(f32_3, $finder<f32, 3>, f32, 3);
            oracle_suite!(f64_2, $finder<f64, 2>, f64, 2);
            oracle_suite!(f64_3, $finder<f64, 3>, f64, 3);
            $(oracle_suite!($more, $finder<$real, $dim>, $real, $dim);)*
        }
    };
}

mod brute_force {
    use super::*;

    oracle_suite!(f32_2, BruteForce, f32, 2);
    oracle_suite!(f32_3, BruteForce, f32, 3);
    oracle_suite!(f64_2, BruteForce, f64, 2);
    oracle_suite!(f64_3, BruteForce, f64, 3);
}

// One dimension and four are unusual, but allowed.
suites!(grid_sweep, GridSweep, f32_1 f32, 1, f64_4 f64, 4);
suites!(grid_sweep_in_slabs, InSlabs);
suites!(rank_sweep, RankSweep, f32_1 f32, 1, f64_4 f64, 4);
