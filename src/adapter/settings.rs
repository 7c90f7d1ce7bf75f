//! What a user may choose.

use super::rapier::math::{DIM, Real};
use super::version;
use crate::pair_tracker::{GridLayers, Layers, Unlayered};

/// How an [`UnisizeBroadPhase`](super::UnisizeBroadPhase) works. The default suits every scene.
///
/// What is left out where settings are read by serde is as by default.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize),
    serde(default)
)]
pub struct Settings {
    /// What finds the pairs. It decides the speed, never the answer. Default: [`Kernel::GridSweep`].
    pub kernel: Kernel,
    /// How far a collider may move before its box is renewed once more, on every side, in multiples of
    /// [`IntegrationParameters::length_unit`](super::rapier::dynamics::IntegrationParameters::length_unit).
    ///
    /// A new box has no margin, until its collider first moves. The larger, the less often boxes change and the more pairs are reported that do not touch. Usual
    /// values are between 0 and a tenth of a collider's size; negative and NaN ones count as 0. The default
    /// is the margin of Rapier's own broad phase, 0.01 in version 0.27 and 0.04 in 0.36, and makes the boxes the same as
    /// there.
    pub margin: Real,
    /// For how many of their last moves ahead colliders are searched for. It decides the speed, never the answer. Default:
    /// `None`, as far as the pairs that it finds too early are worth it, which depends on how fast things move, how
    /// densely they lie and how straight they go. 0 searches for nothing ahead of time, and more than 64
    /// count as 64. A number that is too large for the scene costs time and memory.
    pub foresight: Option<u16>,
    /// Whether the few colliders that have moved otherwise than was foreseen are looked up among the others. If not,
    /// every search is for all. It decides the speed, never the answer. Default: `true`.
    pub layers: bool,
    /// Whether each update takes the time of its phases, for [`Stats::times`](super::Stats::times). Default: no, so that
    /// no update looks at the clock.
    pub timed: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            kernel: Kernel::default(),
            margin: version::MARGIN,
            foresight: None,
            layers: true,
            timed: false,
        }
    }
}

/// What finds the pairs among the boxes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
#[non_exhaustive]
pub enum Kernel {
    /// [`GridSweep`](crate::GridSweep), the fast one.
    #[default]
    GridSweep,
    /// [`RankSweep`](crate::RankSweep), the algorithm of Capannini and Larsson, for study.
    RankSweep,
    /// [`BruteForce`](crate::BruteForce), every box against every other, for tests.
    BruteForce,
}

impl Kernel {
    /// The kernel itself, with empty layers.
    pub(super) fn layers(self, are_used: bool) -> Layers<Real, DIM> {
        match self {
            Self::GridSweep => Layers::Grid(Box::new(GridLayers::new(are_used))),
            Self::RankSweep => Layers::Rank(Box::default()),
            Self::BruteForce => Layers::Brute(Unlayered::default()),
        }
    }
}
