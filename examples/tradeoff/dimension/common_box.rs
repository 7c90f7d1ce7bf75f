//! The paper's kernel as published: every box is represented by one of a common size, and every pair that is found is reported.
//!
//! It then needs no test of candidates, but reports pairs whose boxes do not overlap, more of them the more sizes differ. Every
//! update searches all boxes anew. If the common size is that of the largest box, nothing is missed. If it is less, larger boxes
//! are represented too small, about their centres, and pairs are missed.

use super::anew::{BySize, FindAll, Proxy, extent, movable_extents};
use super::scenes::rapier::{math::DIM, prelude::*};
use crate::quantile::quantile;
use unisize::{Aabb, PairFinder, RankSweep};

/// The paper's kernel on boxes of one size.
pub(super) struct CommonBox {
    /// The common size is this quantile of the extents of movable boxes, on each axis.
    share: f64,
    sweep: RankSweep<Real, DIM>,
    /// Scratch memory.
    by_size: BySize,
    extents: Vec<Real>,
    boxes: Vec<Aabb<Real, DIM>>,
}

impl CommonBox {
    /// The common size is this quantile of the sizes of movable boxes; 1 is the largest.
    pub(super) fn new(share: f64) -> Self {
        Self {
            share,
            sweep: RankSweep::default(),
            by_size: BySize::default(),
            extents: Vec::new(),
            boxes: Vec::new(),
        }
    }
}

impl Default for CommonBox {
    fn default() -> Self {
        Self::new(1.0)
    }
}

impl FindAll for CommonBox {
    fn find(&mut self, proxies: &[Option<Proxy>], pairs: &mut Vec<[u32; 2]>) {
        self.by_size.part(proxies);
        let by_size = &self.by_size;
        let mut size = by_size.largest;
        if self.share < 1.0 {
            for (axis, size) in size.iter_mut().enumerate() {
                self.extents.clear();
                self.extents.extend(movable_extents(proxies, axis));
                *size = quantile(&mut self.extents, self.share).unwrap_or(*size);
            }
        }
        self.boxes.clear();
        let common = by_size.usual.iter().map(|(_, aabb)| resized(aabb, &size));
        self.boxes.extend(common);
        let swept = self.sweep.find_pairs(&self.boxes, pairs);
        swept.expect("the boxes of a sane scene are valid");
        for pair in pairs.iter_mut() {
            // Slots are in order, so the smaller one stays in front.
            *pair = pair.map(|index| by_size.usual[index as usize].0);
        }
        by_size.find_large(pairs);
    }
}

/// The box with these extents: enlarged from its lower corner, or made smaller about its centre.
fn resized(aabb: &Aabb<Real, DIM>, size: &[Real; DIM]) -> Aabb<Real, DIM> {
    let excess: [Real; DIM] = std::array::from_fn(|k| (extent(aabb, k) - size[k]).max(0.0));
    let mins = std::array::from_fn(|k| aabb.mins[k] + excess[k] / 2.0);
    let maxs = std::array::from_fn(|k| match excess[k] > 0.0 {
        true => aabb.maxs[k] - excess[k] / 2.0,
        false => aabb.maxs[k].max(aabb.mins[k] + size[k]),
    });
    Aabb::new(mins, maxs)
}

#[cfg(test)]
mod tests {
    use super::super::scenes::rapier::{math::DIM, prelude::*};
    use super::{CommonBox, FindAll, Proxy, resized};
    use unisize::Aabb;

    fn cube(at: Real, size: Real) -> Aabb<Real, DIM> {
        Aabb::new([at; DIM], [at + size; DIM])
    }

    fn pairs(share: f64, boxes: &[Aabb<Real, DIM>]) -> Vec<[u32; 2]> {
        let proxy = |(index, &aabb): (usize, _)| {
            Some(Proxy {
                handle: ColliderHandle::from_raw_parts(index as u32, 0),
                can_move: true,
                aabb,
            })
        };
        let proxies: Vec<_> = boxes.iter().enumerate().map(proxy).collect();
        let mut pairs = Vec::new();
        CommonBox::new(share).find(&proxies, &mut pairs);
        pairs.sort_unstable();
        pairs
    }

    #[test]
    fn boxes_get_the_common_size() {
        let size = [2.0; DIM];
        assert_eq!(resized(&cube(0.0, 1.0), &size), cube(0.0, 2.0));
        assert_eq!(resized(&cube(0.0, 2.0), &size), cube(0.0, 2.0));
        assert_eq!(resized(&cube(0.0, 6.0), &size), cube(2.0, 2.0));
    }

    #[test]
    fn a_size_that_is_too_small_misses_pairs() {
        // Three of size 1, of which the third meets the large one near its corner only.
        let boxes = [
            cube(-20.0, 1.0),
            cube(-10.0, 1.0),
            cube(4.5, 1.0),
            cube(0.0, 5.0),
        ];
        assert_eq!(pairs(1.0, &boxes), [[2, 3]]);
        assert!(pairs(0.5, &boxes).is_empty());
    }
}
