//! Parry's bounding volume hierarchy, rebuilt for each call and traversed against itself: one source, compiled once in each
//! dimension.

use super::rapier::math::DIM;
use super::rapier::parry::bounding_volume;
use super::rapier::parry::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};
use unisize::{Aabb, InvalidInput, PairFinder};

/// The tree of one dimension.
#[derive(Default)]
pub(crate) struct Hierarchy {
    tree: Bvh,
    workspace: BvhWorkspace,
}

impl PairFinder<f32, DIM> for Hierarchy {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<f32, DIM>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        let leaf = |b: &Aabb<_, DIM>| bounding_volume::Aabb::new(b.mins.into(), b.maxs.into());
        let leaves = boxes.iter().map(leaf).enumerate();
        self.tree = Bvh::from_iter(BvhBuildStrategy::Binned, leaves);
        pairs.clear();
        let push = &mut |a: u32, b: u32| pairs.push([a.min(b), a.max(b)]);
        let workspace = &mut self.workspace;
        self.tree
            .traverse_bvtt_single_tree::<false>(workspace, push);
        Ok(())
    }
}
