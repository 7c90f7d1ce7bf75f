//! The trait of all kernels: boxes in, overlapping pairs out.

use core::cmp::Ordering;

use crate::aabb::Aabb;
use crate::invalid_input::{InvalidInput, InvalidInputReason};
use crate::real::Real;

/// Finds all overlapping pairs among boxes. The pair finders of this crate are called kernels.
///
/// A finder owns only scratch memory, which it keeps between calls to save allocations. The pairs depend on the arguments alone. You may
/// implement the trait for your own pair finders, for example to compare them. If the trait ever gains another method, that method will
/// have a default.
///
/// ```
/// use unisize::{Aabb, BruteForce, GridSweep, InvalidInput, PairFinder, RankSweep, Real};
///
/// /// The sorted pairs of any pair finder, for any scalar and dimension.
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
    /// Replaces `pairs` by all overlapping pairs of `boxes`, each once and with the smaller index first.
    ///
    /// Boxes are closed and their overlap is exact, as in [`Aabb::intersects`]. Each finder has its own order of the pairs, which is the
    /// same in every run.
    ///
    /// # Errors
    /// [`InvalidInput`] names the first box that has a NaN or `mins > maxs`, or the first box beyond the most that the finder takes.
    /// `pairs` is then empty.
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput>;
}

/// Refuses more boxes than a finder can number.
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

/// Returns the pair of two different indices, smaller first.
#[inline]
pub(crate) fn ordered(a: u32, b: u32) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
