//! The suite: one source for every flavour, which the module that includes it names as `rapier`.

use super::rapier;
use super::{Kernel, Settings, UnisizeBroadPhase};

mod checked;
mod direct;
mod model;
mod pipelines;
mod runner;
mod world;

/// Instantiates the tests for one kernel.
macro_rules! sequences_with {
    ($name:ident, $kernel:expr) => {
        mod $name {
            use super::{Kernel, direct, pipelines, runner};

            #[test]
            fn lists_made_by_hand() {
                runner::check(|sequence| direct::play(sequence, $kernel));
            }

            #[test]
            fn steps_of_the_collision_pipeline() {
                runner::check(|sequence| pipelines::play_collisions(sequence, $kernel));
            }

            #[test]
            fn steps_of_the_physics_pipeline() {
                runner::check(|sequence| pipelines::play_physics(sequence, $kernel));
            }
        }
    };
}

sequences_with!(grid_sweep, Kernel::GridSweep);
sequences_with!(rank_sweep, Kernel::RankSweep);
