//! Sweep and prune in its original form: one axis is sorted and swept, and what overlaps there is tested.

use crate::active_list::ActiveList;
use crate::check_boxes;
use crate::endpoints::{self, Endpoint};
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
    endpoints: Vec<Endpoint<R>>,
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
        endpoints::sort(boxes, 0, &mut self.endpoints);
        let order = self.endpoints.iter().map(|&(_, endpoint)| endpoint);
        self.active.sweep(order, boxes, pairs);
        Ok(())
    }
}
