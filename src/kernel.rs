//! Which [`PairFinder`](crate::PairFinder) a broad phase uses: its kernel.

/// Which of the crate's pair finders a broad phase searches with. It decides the speed, never the answer.
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
