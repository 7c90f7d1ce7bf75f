//! The endpoints of boxes on one axis, in order.
//!
//! An axis has `2n` endpoints: the low one of object `i` is `i`, the high one `i + n`. At equal coordinates lows come before
//! highs, as closed boxes require, and each kind is in the order of object ids.

use unisize::{Aabb, Real};

/// A coordinate, and the endpoint that is there.
pub(crate) type Endpoint<R> = (R, u32);

/// Replaces `endpoints` by those of an axis, in order.
///
/// Computes in **O(n)** time, by a stable radix sort.
pub(crate) fn sort<R: Real, const D: usize>(
    boxes: &[Aabb<R, D>],
    axis: usize,
    endpoints: &mut Vec<Endpoint<R>>,
) {
    endpoints.clear();
    endpoints.extend((0..2 * boxes.len() as u32).map(|e| (coordinate(boxes, axis, e), e)));
    if size_of::<R>() == size_of::<f32>() {
        radsort::sort_by_key(endpoints, |e| e.0.to_f64() as f32);
    } else {
        radsort::sort_by_key(endpoints, |e| e.0.to_f64());
    }
}

/// Where an endpoint is. Zeros have no sign here, because -0 and +0 must tie.
#[inline]
fn coordinate<R: Real, const D: usize>(boxes: &[Aabb<R, D>], axis: usize, endpoint: u32) -> R {
    let at = endpoint as usize;
    let signed = match at.checked_sub(boxes.len()) {
        None => boxes[at].mins[axis],
        Some(object) => boxes[object].maxs[axis],
    };
    signed + R::default()
}
