//! The suite: one source for every flavour, which the module that includes it names as `rapier`, and what depends on
//! Rapier's version as `version`.

#[cfg(test)]
use super::solids;
use super::{Kernel, Settings, UnisizeBroadPhase, rapier, version};

pub(super) mod checked;
mod direct;
#[cfg(test)]
mod distances;
mod model;
#[cfg(test)]
pub(super) mod runner;
#[cfg(test)]
mod shapes;
mod volume;
mod world;

#[cfg(test)]
pub(super) use shapes::Solid;
pub(super) use world::{HandedOver, World};

/// Plays a sequence with lists made by hand, with one of the kernels.
pub(crate) fn play(sequence: &crate::ops::Sequence, kernel: usize) {
    let kernels = [Kernel::GridSweep, Kernel::RankSweep, Kernel::BruteForce];
    direct::play(sequence, kernels[kernel % kernels.len()]);
}

#[cfg(test)]
#[test]
fn lists_made_by_hand_with_grid_sweep() {
    runner::check(|sequence| direct::play(sequence, Kernel::GridSweep));
}

#[cfg(test)]
#[test]
fn lists_made_by_hand_with_rank_sweep() {
    runner::check(|sequence| direct::play(sequence, Kernel::RankSweep));
}
