//! The error of finding pairs.

use thiserror::Error;

/// Why a [`PairFinder`](crate::PairFinder) refuses its input, and at which box.
///
/// ```
/// use unisize::{Aabb, GridSweep, InvalidInputReason, PairFinder};
///
/// let boxes = [Aabb::new([0.0, 0.0], [1.0, 1.0]), Aabb::new([0.0, f32::NAN], [1.0, 1.0])];
/// let mut pairs = vec![[3, 4]];
/// let error = GridSweep::default().find_pairs(&boxes, &mut pairs).unwrap_err();
/// assert_eq!((error.index, error.reason), (1, InvalidInputReason::NotANumber { axis: 1 }));
/// assert_eq!(error.to_string(), "box 1 has a NaN on axis 1");
/// assert!(pairs.is_empty());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("box {index} {reason}")]
#[non_exhaustive]
pub struct InvalidInput {
    /// The index of the first box that is refused.
    pub index: usize,
    /// Why it is refused.
    pub reason: InvalidInputReason,
}

impl InvalidInput {
    /// The error for this box, for pair finders of your own.
    ///
    /// ```
    /// use unisize::{InvalidInput, InvalidInputReason};
    ///
    /// let error = InvalidInput::new(7, InvalidInputReason::TooMany);
    /// assert_eq!(error.to_string(), "box 7 is one more than this kernel takes");
    /// ```
    pub const fn new(index: usize, reason: InvalidInputReason) -> Self {
        Self { index, reason }
    }
}

/// Why a box is refused: see [`InvalidInput`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum InvalidInputReason {
    /// A coordinate on this axis is NaN.
    #[error("has a NaN on axis {axis}")]
    NotANumber {
        /// The first axis with a NaN.
        axis: usize,
    },
    /// `mins > maxs` on this axis.
    #[error("is inverted: mins > maxs on axis {axis}")]
    Inverted {
        /// The first inverted axis.
        axis: usize,
    },
    /// There are more boxes than the kernel can number; its documentation states the limit. The index is that limit.
    #[error("is one more than this kernel takes")]
    TooMany,
}
