//! Parry's bounding volume hierarchy, rebuilt for each call, in the same memory, and traversed against itself: one source, compiled once in
//! each dimension.

use super::rapier::math::DIM;
use super::rapier::parry::bounding_volume;
use super::rapier::parry::partitioning::{Bvh, BvhBuildStrategy, BvhWorkspace};
use unisize::{Aabb, InvalidInput, PairFinder};

/// The tree, built in either way.
pub(crate) type Binned = Hierarchy<false>;
pub(crate) type Ploc = Hierarchy<true>;

/// The tree of one dimension, built by PLOC or by binning.
#[derive(Default)]
pub(crate) struct Hierarchy<const IS_PLOC: bool> {
    tree: Bvh,
    workspace: BvhWorkspace,
}

impl<const IS_PLOC: bool> PairFinder<f32, DIM> for Hierarchy<IS_PLOC> {
    fn find_pairs(
        &mut self,
        boxes: &[Aabb<f32, DIM>],
        pairs: &mut Vec<[u32; 2]>,
    ) -> Result<(), InvalidInput> {
        let leaf = |b: &Aabb<_, DIM>| bounding_volume::Aabb::new(b.mins.into(), b.maxs.into());
        let leaves = boxes.iter().map(leaf).enumerate();
        let strategy = match IS_PLOC {
            true => BvhBuildStrategy::Ploc,
            false => BvhBuildStrategy::Binned,
        };
        if self.tree.is_empty() {
            self.tree = Bvh::from_iter(strategy, leaves);
        } else {
            for (index, leaf) in leaves {
                self.tree.insert_or_update_partially(leaf, index as u32, 0.0);
            }
            self.tree.rebuild(&mut self.workspace, strategy);
        }
        pairs.clear();
        let push = &mut |a: u32, b: u32| pairs.push([a.min(b), a.max(b)]);
        let workspace = &mut self.workspace;
        self.tree
            .traverse_bvtt_single_tree::<false>(workspace, push);
        Ok(())
    }
}
