//! The error of finding pairs.

use thiserror::Error;

/// A box that a [`PairFinder`](crate::PairFinder) refuses, and the reason.
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
    /// The reason.
    pub reason: InvalidInputReason,
}

impl InvalidInput {
    /// Returns the error for a box, for your own pair finders.
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

/// The reason why a box is refused: see [`InvalidInput`].
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
    /// There are more boxes than the kernel takes. The index is the limit, which the kernel's documentation states.
    #[error("is one more than this kernel takes")]
    TooMany,
}
