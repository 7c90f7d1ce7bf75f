//! The boxes among which pairs are sought.

use std::ops::Range;

use crate::aabb::Aabb;
use crate::real::Real;

/// Indices of boxes, each once, in any order.
pub(super) trait Members: Copy + Send + Sync {
    /// Whether a box may be invalid.
    const MAY_BE_INVALID: bool;

    fn count(self) -> usize;

    /// The index of the box of the `i`-th member.
    fn index(self, i: usize) -> u32;

    /// Calls `visit` with each member of the range: its place in the range, its index, and its box.
    ///
    /// Compiled better than an iterator would be.
    fn for_each<R: Real, const D: usize>(
        self,
        boxes: &[Aabb<R, D>],
        range: Range<usize>,
        visit: impl FnMut(usize, u32, &Aabb<R, D>),
    );
}

/// So many boxes, all that there are.
#[derive(Clone, Copy)]
pub(super) struct Everyone(pub(super) usize);

impl Members for Everyone {
    const MAY_BE_INVALID: bool = true;

    fn count(self) -> usize {
        self.0
    }

    fn index(self, i: usize) -> u32 {
        i as u32
    }

    #[inline(always)]
    fn for_each<R: Real, const D: usize>(
        self,
        boxes: &[Aabb<R, D>],
        range: Range<usize>,
        mut visit: impl FnMut(usize, u32, &Aabb<R, D>),
    ) {
        let start = range.start;
        for (i, aabb) in boxes[range].iter().enumerate() {
            visit(i, (start + i) as u32, aabb);
        }
    }
}

/// Valid boxes of these indices.
impl Members for &[u32] {
    const MAY_BE_INVALID: bool = false;

    fn count(self) -> usize {
        self.len()
    }

    fn index(self, i: usize) -> u32 {
        self[i]
    }

    #[inline(always)]
    fn for_each<R: Real, const D: usize>(
        self,
        boxes: &[Aabb<R, D>],
        range: Range<usize>,
        mut visit: impl FnMut(usize, u32, &Aabb<R, D>),
    ) {
        for (i, &index) in self[range].iter().enumerate() {
            visit(i, index, &boxes[index as usize]);
        }
    }
}
