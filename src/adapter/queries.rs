//! Scene queries: rays, points and shapes against the colliders.
//!
//! Rapier asks its questions to the tree of its own broad phase. Here there is no tree until somebody asks:
//! it is built from the boxes at the first query after an update.

use super::UnisizeBroadPhase;
use super::rapier::dynamics::RigidBodySet;
use super::rapier::geometry::{Aabb, ColliderSet};
use super::rapier::parry::partitioning::{Bvh, BvhBuildStrategy};
use super::rapier::parry::query::QueryDispatcher;
use super::rapier::pipeline::{QueryFilter, QueryPipeline, QueryPipelineMut};

impl UnisizeBroadPhase {
    /// The scene as of the last update, for queries. The counterpart of `BroadPhaseBvh::as_query_pipeline`.
    ///
    /// The first call after an update that moved a box builds a tree in **O(n log n)**; further ones are
    /// free.
    pub fn as_query_pipeline<'a>(
        &'a self,
        dispatcher: &'a dyn QueryDispatcher,
        bodies: &'a RigidBodySet,
        colliders: &'a ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipeline<'a> {
        QueryPipeline {
            dispatcher,
            bvh: self.tree(),
            bodies,
            colliders,
            filter,
        }
    }

    /// The same with the sets borrowed mutably. The counterpart of `BroadPhaseBvh::as_query_pipeline_mut`.
    pub fn as_query_pipeline_mut<'a>(
        &'a self,
        dispatcher: &'a dyn QueryDispatcher,
        bodies: &'a mut RigidBodySet,
        colliders: &'a mut ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipelineMut<'a> {
        QueryPipelineMut {
            dispatcher,
            bvh: self.tree(),
            bodies,
            colliders,
            filter,
        }
    }

    fn tree(&self) -> &Bvh {
        self.tree.get_or_init(|| {
            let boxes = self.table.boxes();
            let leaves = boxes.map(|(slot, &aabb)| (slot as usize, Aabb::from(aabb)));
            if self.stats().proxies > 2 {
                return Bvh::from_iter(BvhBuildStrategy::Binned, leaves);
            }
            // Parry builds trees of one and two leaves only if their indices are 0 and 1.
            let mut tree = Bvh::new();
            for (slot, aabb) in leaves {
                tree.insert(aabb, slot as u32);
            }
            tree
        })
    }
}
