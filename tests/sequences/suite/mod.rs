//! The suite: one source for every flavour, which the module that includes it names as `rapier`.

use super::rapier;
use super::{Kernel, Settings, UnisizeBroadPhase};

mod checked;
mod direct;
mod model;
#[cfg(test)]
mod pipelines;
#[cfg(test)]
mod runner;
mod world;

/// Plays a sequence with lists made by hand, with one of the kernels.
pub(crate) fn play(sequence: &crate::ops::Sequence, kernel: usize) {
    let kernels = [Kernel::GridSweep, Kernel::RankSweep, Kernel::BruteForce];
    direct::play(sequence, kernels[kernel % kernels.len()]);
}

/// Instantiates the tests for one kernel.
#[cfg(test)]
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

#[cfg(test)]
sequences_with!(grid_sweep, Kernel::GridSweep);
#[cfg(test)]
sequences_with!(rank_sweep, Kernel::RankSweep);
