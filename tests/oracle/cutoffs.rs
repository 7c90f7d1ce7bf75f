//! The streamed segment tree with another cutoff.

use crate::numbers::Number;
use unisize::{Aabb, InvalidInput, PairFinder};
use unisize_reference::StreamedSegmentTree;

/// [`StreamedSegmentTree`] with this cutoff.
pub(crate) struct WithCutoff<R, const D: usize, const CUTOFF: usize>(StreamedSegmentTree<R, D>);

impl<R: Number, const D: usize, const CUTOFF: usize> Default for WithCutoff<R, D, CUTOFF> {
    fn default() -> Self {
        Self(StreamedSegmentTree::with_cutoff(CUTOFF))
    }
}

impl<R: Number, const D: usize, const CUTOFF: usize> PairFinder<R, D> for WithCutoff<R, D, CUTOFF> {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        self.0.find_pairs(boxes, pairs)
    }
}
