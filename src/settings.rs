//! What a user may choose.

use crate::pair_filter::PairFilter;
use crate::real::Real;

/// How a broad phase works. The defaults suit most scenes; `docs/guide.md` says which filter to choose.
///
/// `R` is the scalar of the engine; `Settings` in each adapter is this type with the engine's own. A field that is missing from
/// serialized settings has its default. Later versions may add settings, so make them from the default:
///
/// ```
/// use unisize::{PairFilter, Settings};
///
/// let settings = Settings::<f32>::default().with_margin(0.05);
/// assert_eq!((settings.margin, settings.filter), (Some(0.05), None));
/// # assert_eq!(settings.with_filter(PairFilter::Off).filter, Some(PairFilter::Off));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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
    /// How far a collider may move before its box is renewed: the margin on every side, in multiples of Rapier's
    /// `IntegrationParameters::length_unit`.
    ///
    /// A new box has no margin until its collider first moves. With a larger margin boxes change less often, and more pairs that do
    /// not touch are reported. Usual values are between 0 and a tenth of a collider's size; negative numbers and NaN count as 0.
    /// Default: `None`, the margin of Rapier's own broad phase, so that boxes are the same: 0.01 in version 0.27, and 0.04 in 0.36.
    pub margin: Option<R>,
    /// Which pairs are left out because they can have no effect. Default: `None`, which is [`PairFilter::Off`] for Rapier 0.27
    /// and [`PairFilter::Shapes`] for 0.36.
    pub filter: Option<PairFilter>,
}

impl<R: Real> Settings<R> {
    /// Returns the settings with [`margin`](Self::margin) replaced.
    pub fn with_margin(self, margin: impl Into<Option<R>>) -> Self {
        let margin = margin.into();
        Self { margin, ..self }
    }

    /// Returns the settings with [`filter`](Self::filter) replaced.
    pub fn with_filter(self, filter: impl Into<Option<PairFilter>>) -> Self {
        let filter = filter.into();
        Self { filter, ..self }
    }
}
