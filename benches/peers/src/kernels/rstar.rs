//! rstar: an R*-tree, loaded in bulk, and intersected with itself or asked for what overlaps each box.
//!
//! Boxes are closed there as well. Either way names every pair twice and every box with itself; one of the two
//! is kept. The size of a node can be set for the second way only.

use super::contender::{Family, Frame, Setting};
use anyhow::Result;
use rstar::{AABB, Point, RStarInsertionStrategy, RTree, RTreeObject, RTreeParams};

/// rstar at its best; nodes of 6 are its default, and what the intersection of trees has.
pub(crate) fn family<const D: usize>() -> Family<D>
where
    [f32; D]: Point<Scalar = f32>,
{
    let settings = [
        Setting::listing("intersected", || intersected),
        Setting::listing("nodes of 6", || query::<6, D>),
        Setting::listing("nodes of 12", || query::<12, D>),
        Setting::listing("nodes of 24", || query::<24, D>),
    ];
    Family::new("rstar", settings)
}

struct IndexedBox<const D: usize> {
    corners: [[f32; D]; 2],
    index: u32,
}

impl<const D: usize> RTreeObject for IndexedBox<D>
where
    [f32; D]: Point<Scalar = f32>,
{
    type Envelope = AABB<[f32; D]>;

    fn envelope(&self) -> Self::Envelope {
        AABB::from_corners(self.corners[0], self.corners[1])
    }
}

fn indexed<const D: usize>(frame: &Frame<D>) -> Vec<IndexedBox<D>> {
    let boxes = (0..).zip(&frame.corners);
    let indexed = |(index, &corners)| IndexedBox { corners, index };
    boxes.map(indexed).collect()
}

fn intersected<const D: usize>(frame: &Frame<D>, pairs: &mut Vec<[u32; 2]>) -> Result<()>
where
    [f32; D]: Point<Scalar = f32>,
{
    let tree = RTree::bulk_load(indexed(frame));
    let twice = tree.intersection_candidates_with_other_tree(&tree);
    let once = twice.filter(|(a, b)| a.index < b.index);
    pairs.extend(once.map(|(a, b)| [a.index, b.index]));
    Ok(())
}

/// Nodes of up to so many children.
struct NodesOf<const MAX: usize>;

impl<const MAX: usize> RTreeParams for NodesOf<MAX> {
    const MIN_SIZE: usize = MAX / 2;
    const MAX_SIZE: usize = MAX;
    const REINSERTION_COUNT: usize = MAX / 3;
    type DefaultInsertionStrategy = RStarInsertionStrategy;
}

fn query<const MAX: usize, const D: usize>(
    frame: &Frame<D>,
    pairs: &mut Vec<[u32; 2]>,
) -> Result<()>
where
    [f32; D]: Point<Scalar = f32>,
{
    let tree = RTree::<_, NodesOf<MAX>>::bulk_load_with_params(indexed(frame));
    // In the order of the tree, where the next box is near the last one.
    for a in tree.iter() {
        let overlapping = tree.locate_in_envelope_intersecting(&a.envelope());
        let once = overlapping.filter(|b| a.index < b.index);
        pairs.extend(once.map(|b| [a.index, b.index]));
    }
    Ok(())
}
