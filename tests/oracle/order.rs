//! The order of boxes: rearrangements of a list.

use core::cmp::Ordering;

use crate::numbers::Number;
use unisize::Aabb;

/// The boxes by where they begin on `axis`, least first.
pub(crate) fn sorted<R: Number, const D: usize>(
    mut boxes: Vec<Aabb<R, D>>,
    axis: usize,
) -> Vec<Aabb<R, D>> {
    boxes.sort_by(|a, b| compare(a.mins[axis], b.mins[axis]));
    boxes
}

/// The boxes in the opposite order.
pub(crate) fn reversed<R: Number, const D: usize>(mut boxes: Vec<Aabb<R, D>>) -> Vec<Aabb<R, D>> {
    boxes.reverse();
    boxes
}

/// The boxes by where they begin on `axis`, least first, but for a few neighbours that changed places, as
/// happens from one frame to the next.
pub(crate) fn almost_sorted<R: Number, const D: usize>(
    boxes: Vec<Aabb<R, D>>,
    axis: usize,
) -> Vec<Aabb<R, D>> {
    let mut boxes = sorted(boxes, axis);
    for pair in boxes.chunks_exact_mut(2).step_by(5) {
        pair.swap(0, 1);
    }
    boxes
}

/// How two coordinates compare; a generator makes no NaN.
fn compare<R: Number>(a: R, b: R) -> Ordering {
    a.partial_cmp(&b).expect("the coordinates are numbers")
}
