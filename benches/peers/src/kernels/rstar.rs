//! rstar: an R*-tree, loaded in bulk, and intersected with itself or asked for what overlaps each box.
//!
//! Boxes are closed there as well. Either way names every pair twice and every box with itself; one of the two
//! is kept. The size of a node can be set for the second way only.

use super::contender::{Family, Kernel, Setting};
use super::frame::Frame;
use anyhow::Result;
use rstar::{AABB, Point, RStarInsertionStrategy, RTree, RTreeObject, RTreeParams};

/// rstar at its best; nodes of 6 are its default, and what the intersection of trees has.
pub(crate) fn family<const D: usize>() -> Family<D>
where
    [f32; D]: Point<Scalar = f32>,
{
    let settings = [
        Setting::new("intersected", || Ok(Intersected::default())),
        Setting::new("nodes of 6", || Ok(Queried::<6>::default())),
        Setting::new("nodes of 12", || Ok(Queried::<12>::default())),
        Setting::new("nodes of 24", || Ok(Queried::<24>::default())),
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
    let boxes = frame.corners.iter().enumerate();
    let indexed = |(index, &corners): (usize, &[[f32; D]; 2])| IndexedBox {
        corners,
        index: index as u32,
    };
    boxes.map(indexed).collect()
}

#[derive(Default)]
struct Intersected {
    pairs: Vec<[u32; 2]>,
}

impl<const D: usize> Kernel<D> for Intersected
where
    [f32; D]: Point<Scalar = f32>,
{
    fn find_pairs(&mut self, frame: &Frame<D>) -> Result<()> {
        let tree = RTree::bulk_load(indexed(frame));
        self.pairs.clear();
        let twice = tree.intersection_candidates_with_other_tree(&tree);
        let once = twice.filter(|(a, b)| a.index < b.index);
        self.pairs.extend(once.map(|(a, b)| [a.index, b.index]));
        Ok(())
    }

    fn pairs(&self) -> &[[u32; 2]] {
        &self.pairs
    }
}

#[derive(Default)]
struct Queried<const MAX: usize> {
    pairs: Vec<[u32; 2]>,
}

/// Nodes of up to so many children.
struct NodesOf<const MAX: usize>;

impl<const MAX: usize> RTreeParams for NodesOf<MAX> {
    const MIN_SIZE: usize = MAX / 2;
    const MAX_SIZE: usize = MAX;
    const REINSERTION_COUNT: usize = MAX / 3;
    type DefaultInsertionStrategy = RStarInsertionStrategy;
}

impl<const MAX: usize, const D: usize> Kernel<D> for Queried<MAX>
where
    [f32; D]: Point<Scalar = f32>,
{
    fn find_pairs(&mut self, frame: &Frame<D>) -> Result<()> {
        let tree = RTree::<_, NodesOf<MAX>>::bulk_load_with_params(indexed(frame));
        self.pairs.clear();
        // In the order of the tree, where the next box is near the last one.
        for a in tree.iter() {
            let overlapping = tree.locate_in_envelope_intersecting(&a.envelope());
            let once = overlapping.filter(|b| a.index < b.index);
            self.pairs.extend(once.map(|b| [a.index, b.index]));
        }
        Ok(())
    }

    fn pairs(&self) -> &[[u32; 2]] {
        &self.pairs
    }
}
