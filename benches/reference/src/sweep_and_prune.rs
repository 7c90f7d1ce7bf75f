//! Sweep and prune in its original form: one axis is sorted and swept, and what overlaps there is tested.

use crate::active_list::ActiveList;
use crate::check_boxes;
use unisize::{Aabb, InvalidInput, PairFinder, Real};

/// Sweep and prune on one axis: Baraff, *Dynamic simulation of non-penetrating rigid bodies* (1992), as section 3 of
/// Capannini and Larsson's paper has it.
///
/// The endpoints of the first axis are sorted and swept. At its low endpoint a box enters the active list; at its high
/// endpoint it leaves the list and is tested against all that remain. These overlap on the first axis anyway, so only
/// the further axes are compared, eight boxes at once.
///
/// Computes in **O(n k)** time, where k is how many boxes overlap at once on the first axis, and **O(n)** memory beside
/// the pairs. With n boxes evenly spread in a square, k grows as √n, in a cube as n to the power of ⅔. One long box adds at
/// most one to k, however long it is.
///
/// The axes are taken in the given order: let the first be one along which boxes are spread out. `D` must not be 0.
#[derive(Clone, Debug, Default)]
pub struct SweepAndPrune<R, const D: usize> {
    /// Scratch memory: the endpoints in order.
    endpoints: Vec<(R, u32)>,
    active: ActiveList<R, D>,
}

impl<R: Real, const D: usize> PairFinder<R, D> for SweepAndPrune<R, D> {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<R, D>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        const { assert!(D > 0, "boxes need an axis") };
        pairs.clear();
        check_boxes(boxes)?;
        sort(boxes, &mut self.endpoints);
        let order = self.endpoints.iter().map(|&(_, endpoint)| endpoint);
        self.active.sweep(order, boxes, pairs);
        Ok(())
    }
}

/// Replaces `endpoints` by those of the first axis in order, each with its coordinate. The low endpoint of object `i` is `i`, the high one
/// `i + n`. At equal coordinates lows come before highs, as closed boxes require, and each kind is in the order of object ids.
///
/// Computes in **O(n)** time, by a stable radix sort.
fn sort<R: Real, const D: usize>(boxes: &[Aabb<R, D>], endpoints: &mut Vec<(R, u32)>) {
    // Zeros have no sign here, because -0 and +0 must tie.
    let unsigned = |x: R| x + R::default();
    let lows = boxes.iter().map(|aabb| unsigned(aabb.mins[0]));
    let highs = boxes.iter().map(|aabb| unsigned(aabb.maxs[0]));
    endpoints.clear();
    endpoints.extend(lows.chain(highs).zip(0..));
    if size_of::<R>() == size_of::<f32>() {
        radsort::sort_by_key(endpoints, |e| e.0.to_f64() as f32);
    } else {
        radsort::sort_by_key(endpoints, |e| e.0.to_f64());
    }
}
