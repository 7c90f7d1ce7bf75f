//! Every kernel against the oracle: one suite, written once, one line per kernel, scalar and dimension.
//!
//! Inputs have names (`inputs`, with the generators that it draws from), so a failure says which kind of scene went
//! wrong, and shows the fewest boxes found that still fail. `check` lists what must hold for every input, and `errors`
//! what must be refused. `arbitrary` makes random inputs; raise `PROPTEST_CASES` for more. `fuzzed` is what the fuzzer runs, and `replay` runs it on the inputs
//! that the fuzzer has kept.

mod arbitrary;
mod census;
mod check;
mod errors;
mod fuzzed;
mod guard;
mod inputs;
mod limits;
mod numbers;
mod order;
mod placement;
mod random;
mod replay;
mod report;
mod shapes;
mod slabs;

use slabs::InSlabs;
use unisize::{BruteForce, GridSweep, RankSweep};

/// Instantiates the suite for one kernel: the module's name, the kernel, its scalar and its dimension.
macro_rules! oracle_suite {
    ($name:ident, $finder:ty, $real:ty, $dim:literal) => {
        mod $name {
            use super::*;

            inputs::for_every_family!(test_family [$finder, $real, $dim]);

            #[test]
            fn one_finder_serves_all_inputs() {
                check::one_finder_serves::<$finder, $real, $dim>(&inputs::all());
            }

            #[test]
            fn invalid_inputes_are_refused() {
                errors::check::<$finder, $real, $dim>();
            }

            #[test]
            fn arbitrary_boxes() {
                arbitrary::check::<$finder, $real, $dim>();
            }
        }
    };
}

/// Makes a test of every family of inputs.
macro_rules! test_family {
    ([$finder:ty, $real:ty, $dim:literal] $($family:ident)*) => {
        $(
            #[test]
            fn $family() {
                check::every::<$finder, $real, $dim>(&inputs::$family());
            }
        )*
    };
}

oracle_suite!(brute_force_f32_2, BruteForce, f32, 2);
oracle_suite!(brute_force_f32_3, BruteForce, f32, 3);
oracle_suite!(brute_force_f64_2, BruteForce, f64, 2);
oracle_suite!(brute_force_f64_3, BruteForce, f64, 3);

oracle_suite!(grid_sweep_f32_2, GridSweep<f32, 2>, f32, 2);
oracle_suite!(grid_sweep_f32_3, GridSweep<f32, 3>, f32, 3);
oracle_suite!(grid_sweep_f64_2, GridSweep<f64, 2>, f64, 2);
oracle_suite!(grid_sweep_f64_3, GridSweep<f64, 3>, f64, 3);

oracle_suite!(grid_sweep_in_slabs_f32_2, InSlabs<f32, 2>, f32, 2);
oracle_suite!(grid_sweep_in_slabs_f32_3, InSlabs<f32, 3>, f32, 3);
oracle_suite!(grid_sweep_in_slabs_f64_2, InSlabs<f64, 2>, f64, 2);
oracle_suite!(grid_sweep_in_slabs_f64_3, InSlabs<f64, 3>, f64, 3);

// Unusual dimensions, but allowed ones.
oracle_suite!(grid_sweep_f32_1, GridSweep<f32, 1>, f32, 1);
oracle_suite!(grid_sweep_f64_4, GridSweep<f64, 4>, f64, 4);

oracle_suite!(rank_sweep_f32_2, RankSweep<f32, 2>, f32, 2);
oracle_suite!(rank_sweep_f32_3, RankSweep<f32, 3>, f32, 3);
oracle_suite!(rank_sweep_f64_2, RankSweep<f64, 2>, f64, 2);
oracle_suite!(rank_sweep_f64_3, RankSweep<f64, 3>, f64, 3);

mod references {
    use super::*;
    use unisize_reference::SweepAndPrune;

    oracle_suite!(sweep_and_prune_f32_2, SweepAndPrune<f32, 2>, f32, 2);
    oracle_suite!(sweep_and_prune_f32_3, SweepAndPrune<f32, 3>, f32, 3);
    oracle_suite!(sweep_and_prune_f64_2, SweepAndPrune<f64, 2>, f64, 2);
    oracle_suite!(sweep_and_prune_f64_3, SweepAndPrune<f64, 3>, f64, 3);

    // Unusual for these as well.
    oracle_suite!(sweep_and_prune_f32_1, SweepAndPrune<f32, 1>, f32, 1);
    oracle_suite!(sweep_and_prune_f64_4, SweepAndPrune<f64, 4>, f64, 4);
}
