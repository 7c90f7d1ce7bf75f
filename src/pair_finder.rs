//! What every kernel is: a pair finder. Boxes in, overlapping pairs out.

use core::cmp::Ordering;

use crate::aabb::Aabb;
use crate::invalid_input::{InvalidInput, InvalidInputReason};
use crate::real::Real;

/// Finds all overlapping pairs among boxes. The pair finders of this crate are called kernels.
///
/// A finder owns only scratch memory, which it keeps between calls to save allocations; the answer depends on the
/// arguments alone. You may implement the trait for pair finders of your own, say to compare them. Should it ever gain another
/// method, that method will have a default.
///
/// ```
/// use unisize::{Aabb, BruteForce, GridSweep, InvalidInput, PairFinder, RankSweep, Real};
///
/// /// The pairs by any pair finder, of any scalar, in any dimension, sorted.
/// fn sorted_pairs<R: Real, const D: usize>(
///     mut finder: impl PairFinder<R, D>,
///     boxes: &[Aabb<R, D>],
/// ) -> Result<Vec<[u32; 2]>, InvalidInput> {
///     let mut pairs = Vec::new();
///     finder.find_pairs(boxes, &mut pairs)?;
///     pairs.sort_unstable();
///     Ok(pairs)
/// }
///
/// let boxes = [0.0, 0.5, 1.0, 7.0].map(|x: f64| Aabb::new([x, 0.0, 0.0], [x + 1.0, 1.0, 1.0]));
/// let expected = sorted_pairs(BruteForce, &boxes)?;
/// assert_eq!(expected, [[0, 1], [0, 2], [1, 2]]);
/// assert_eq!(sorted_pairs(GridSweep::default(), &boxes)?, expected);
/// assert_eq!(sorted_pairs(RankSweep::default(), &boxes)?, expected);
/// # Ok::<(), InvalidInput>(())
/// ```
pub trait PairFinder<R, const D: usize> {
    /// Replaces `pairs` by every overlapping pair of `boxes`, each once, smaller index first.
    ///
    /// Overlap is closed and exact, as in [`Aabb::intersects`]. The order of the pairs is the finder's own;
    /// it is the same in every run.
    ///
    /// # Errors
    /// [`InvalidInput`] names the first box that has a NaN or `mins > maxs`, or the first box past the number that the
    /// finder can take; `pairs` is then empty.
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput>;
}

/// Refuses more boxes than a finder has numbers for.
pub(crate) fn check_count(count: usize, most: usize) -> Result<(), InvalidInput> {
    match count > most {
        true => Err(InvalidInput::new(most, InvalidInputReason::TooMany)),
        false => Ok(()),
    }
}

/// Refuses invalid boxes, in **O(n)**.
pub(crate) fn check_boxes<R: Real, const D: usize>(
    boxes: &[Aabb<R, D>],
) -> Result<(), InvalidInput> {
    let Some(index) = boxes.iter().position(|b| !b.is_valid()) else {
        return Ok(());
    };
    let Aabb { mins, maxs } = &boxes[index];
    let reason = |axis: usize| match mins[axis].partial_cmp(&maxs[axis]) {
        None => Some(InvalidInputReason::NotANumber { axis }),
        Some(Ordering::Greater) => Some(InvalidInputReason::Inverted { axis }),
        Some(_) => None,
    };
    let reason = (0..D).find_map(reason);
    let reason = reason.expect("a box is invalid on one of its axes");
    Err(InvalidInput::new(index, reason))
}

/// The pair of two different indices, smaller first.
#[inline]
pub(crate) fn ordered(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
