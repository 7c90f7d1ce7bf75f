//! The order of the endpoints of one axis, for boxes of either scalar.

use crate::endpoints::{Endpoints, has_narrow_keys};
use crate::{Aabb, Real};

/// Sorts endpoints. All of it is scratch memory.
#[derive(Clone, Debug, Default)]
pub(super) struct AxisSort {
    /// For 32-bit keys; empty unless boxes are of `f32`.
    narrow: Endpoints<u32>,
    /// For 64-bit keys; empty unless boxes are of `f64`.
    wide: Endpoints<u64>,
}

impl AxisSort {
    /// Replaces `order` by the endpoints of an axis, `i` for lows and `i + n` for highs. They are sorted by coordinate;
    /// at equal coordinates lows come before highs, and each kind is in the order of object ids.
    ///
    /// Computes in **O(n)** time.
    pub(super) fn sort<R: Real, const D: usize>(
        &mut self,
        boxes: &[Aabb<R, D>],
        axis: usize,
        order: &mut Vec<u32>,
    ) {
        if has_narrow_keys::<R>() {
            self.narrow.sort(boxes, axis, order);
        } else {
            self.wide.sort(boxes, axis, order);
        }
    }
}
