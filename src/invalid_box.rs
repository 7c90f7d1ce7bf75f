//! The only way in which finding pairs can fail.

use thiserror::Error;

/// An input that a [`PairFinder`](crate::PairFinder) refuses, with the index of the offending box.
///
/// ```
/// use unisize::{Aabb, GridSweep, InvalidBoxReason, PairFinder};
///
/// let boxes = [Aabb::new([0.0, 0.0], [1.0, 1.0]), Aabb::new([0.0, f32::NAN], [1.0, 1.0])];
/// let mut pairs = vec![[3, 4]];
/// let error = GridSweep::default().find_pairs(&boxes, &mut pairs).unwrap_err();
/// assert_eq!((error.index, error.reason), (1, InvalidBoxReason::NotANumber { axis: 1 }));
/// assert_eq!(error.to_string(), "box 1 has a NaN on axis 1");
/// assert!(pairs.is_empty());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("box {index} {reason}")]
#[non_exhaustive]
pub struct InvalidBox {
    /// The index of the first offending box in the slice that was given.
    pub index: usize,
    /// What is wrong with it.
    pub reason: InvalidBoxReason,
}

impl InvalidBox {
    /// The error about the first offending box, for pair finders that you write.
    ///
    /// ```
    /// use unisize::{InvalidBox, InvalidBoxReason};
    ///
    /// let error = InvalidBox::new(7, InvalidBoxReason::TooMany);
    /// assert_eq!(error.to_string(), "box 7 is one more than this kernel takes");
    /// ```
    pub const fn new(index: usize, reason: InvalidBoxReason) -> Self {
        Self { index, reason }
    }
}

/// What is wrong with an [`InvalidBox`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum InvalidBoxReason {
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
    /// The kernel numbers boxes, or entries of boxes, with 32 bits, and there are more. Its docs say how many it takes.
    #[error("is one more than this kernel takes")]
    TooMany,
}
