//! Parry's bounding volume hierarchy, rebuilt for each call and traversed against itself.

use unisize::{Aabb, InvalidInput, PairFinder};

macro_rules! hierarchy {
    ($name:ident, $rapier:ident, $dimension:literal) => {
        /// The tree of one dimension.
        #[derive(Default)]
        pub(crate) struct $name {
            tree: $rapier::parry::partitioning::Bvh,
            workspace: $rapier::parry::partitioning::BvhWorkspace,
        }

        impl PairFinder<f32, $dimension> for $name {
            fn find_pairs(
                &mut self,
                boxes: &[Aabb<f32, $dimension>],
                pairs: &mut Vec<[u32; 2]>,
            ) -> Result<(), InvalidInput> {
                use $rapier::parry::bounding_volume::Aabb;
                use $rapier::parry::partitioning::{Bvh, BvhBuildStrategy};
                let leaves = boxes
                    .iter()
                    .map(|b| Aabb::new(b.mins.into(), b.maxs.into()));
                self.tree = Bvh::from_iter(BvhBuildStrategy::Binned, leaves.enumerate());
                pairs.clear();
                self.tree
                    .traverse_bvtt_single_tree::<false>(&mut self.workspace, &mut |a, b| {
                        pairs.push([a.min(b), a.max(b)]);
                    });
                Ok(())
            }
        }
    };
}

hierarchy!(Hierarchy2, rapier2d, 2);
hierarchy!(Hierarchy3, rapier3d, 3);
