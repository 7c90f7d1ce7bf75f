//! Compares every kernel with the oracle. The suite is written once, and instantiated in one line per kernel, scalar and dimension.
//!
//! `inputs` and `limits` have named inputs, which consist of the lists of `boxes`. `check` has the checks of valid inputs, and `errors` those of
//! invalid ones. `fuzzed` is the test of the fuzzer; `replay` runs it on random bytes (`PROPTEST_CASES` sets their number) and on the inputs that
//! the fuzzer has kept.

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

#[allow(dead_code, unreachable_pub)] // The laboratory uses all of it.
#[path = "../common/boxes/mod.rs"]
mod arrangements;
#[path = "../common/cases.rs"]
mod cases;
#[path = "../common/random_values.rs"]
mod random_values;

use slabs::InSlabs;
use unisize::{BruteForce, GridSweep, RankSweep};

/// Instantiates the suite with the name of a module, a kernel, its scalar and its dimension.
macro_rules! oracle_suite {
    ($name:ident, $finder:ty, $real:ty, $dim:literal) => {
        mod $name {
            use super::*;

            #[test]
            fn named_inputs_have_the_pairs_of_the_oracle() {
                check::every::<$finder, $real, $dim>(&inputs::all());
            }

            #[test]
            fn invalid_inputs_are_refused() {
                errors::check::<$finder, $real, $dim>();
            }
        }
    };
}

/// Instantiates the suites of a kernel in 2D and 3D with both scalars, and any others that are named.
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

// 1D and 4D are unusual, but allowed.
suites!(grid_sweep, GridSweep, f32_1 f32, 1, f64_4 f64, 4);
suites!(grid_sweep_in_slabs, InSlabs);
suites!(rank_sweep, RankSweep, f32_1 f32, 1, f64_4 f64, 4);
