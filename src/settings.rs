//! What a user may choose.

use crate::kernel::Kernel;
use crate::pair_filter::PairFilter;
use crate::real::Real;

/// How a broad phase works. The defaults are a good start; `docs/guide.md` tells which filter to choose.
///
/// `R` is the scalar of the engine; each adapter's `Settings` is this type with its own. Fields that are missing where
/// settings are read by serde have their defaults. Settings may be added in later versions, so they are made from the
/// default:
///
/// ```
/// use unisize::{Kernel, Settings};
///
/// let settings = Settings::<f32>::default().with_margin(0.05);
/// assert_eq!((settings.margin, settings.kernel), (Some(0.05), Kernel::GridSweep));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize),
    serde(
        default,
        bound(
            serialize = "R: serde::Serialize",
            deserialize = "R: Real + serde::Deserialize<'de>"
        )
    )
)]
#[non_exhaustive]
pub struct Settings<R> {
    /// What finds the pairs. It decides the speed, never the answer. Default: [`Kernel::GridSweep`].
    pub kernel: Kernel,
    /// How far a collider may move before its box is renewed: the margin on every side, in multiples of Rapier's
    /// `IntegrationParameters::length_unit`.
    ///
    /// A new box has no margin until its collider first moves. The larger the margin, the less often boxes change, and
    /// the more pairs are reported that do not touch. Usual values are between 0 and a tenth of a collider's size;
    /// negative and NaN ones count as 0. Default: `None`, the margin of Rapier's own broad phase, 0.01 in version 0.27
    /// and 0.04 in 0.36, which makes the boxes the same as there.
    pub margin: Option<R>,
    /// Which pairs are left out because they can have no effect. Default: `None`, [`PairFilter::Off`] for Rapier 0.27
    /// and [`PairFilter::Shapes`] for 0.36.
    pub filter: Option<PairFilter>,
    /// For studies. How far ahead colliders are searched for, in multiples of their last move. It decides the speed, never the
    /// answer. Default: `None`, for as many moves as take colliders half their size ahead on average, and at most 32.
    /// 0 searches for nothing ahead of time. A number that is too large for the scene costs time and memory.
    #[doc(hidden)]
    pub foresight: Option<u16>,
    /// For studies. Whether the few colliders that have moved otherwise than foreseen are looked up among the others. If not, every
    /// search is for all pairs. It decides the speed, never the answer. Default: `true`.
    #[doc(hidden)]
    pub layers: bool,
    /// Whether each update takes the time of its phases, for [`Stats::times`](crate::Stats::times). Default: `false`, so
    /// that no update reads the clock. On `wasm32-unknown-unknown`, which has none, times are zero.
    pub timed: bool,
}

impl<R> Default for Settings<R> {
    fn default() -> Self {
        Self {
            kernel: Kernel::default(),
            margin: None,
            filter: None,
            foresight: None,
            layers: true,
            timed: false,
        }
    }
}

impl<R: Real> Settings<R> {
    /// The same with another [`kernel`](Self::kernel).
    pub fn with_kernel(self, kernel: Kernel) -> Self {
        Self { kernel, ..self }
    }

    /// The same with another [`margin`](Self::margin).
    pub fn with_margin(self, margin: impl Into<Option<R>>) -> Self {
        let margin = margin.into();
        Self { margin, ..self }
    }

    /// The same with another [`filter`](Self::filter).
    pub fn with_filter(self, filter: impl Into<Option<PairFilter>>) -> Self {
        let filter = filter.into();
        Self { filter, ..self }
    }

    /// The same with a fixed [`foresight`](Self::foresight).
    #[doc(hidden)]
    pub fn with_foresight(self, moves: impl Into<Option<u16>>) -> Self {
        let foresight = moves.into();
        Self { foresight, ..self }
    }

    /// The same with [`layers`](Self::layers), or without.
    #[doc(hidden)]
    pub fn with_layers(self, layers: bool) -> Self {
        Self { layers, ..self }
    }

    /// The same with times of phases, or without: see [`timed`](Self::timed).
    pub fn with_timed(self, timed: bool) -> Self {
        Self { timed, ..self }
    }
}
