//! What may be asked of a broad phase: rays, shapes and points against the colliders.
//!
//! Rapier's `BroadPhase` trait has no queries; each broad phase has a function `as_query_pipeline` instead, from which comes the
//! tree that scenes ask.

use super::rapier::parry::partitioning::{Bvh, BvhBuildStrategy};
use super::rapier::parry::query::{DefaultQueryDispatcher, QueryDispatcher};
use super::rapier::prelude::*;
use super::world::World;
use std::sync::LazyLock;

/// The function `as_query_pipeline` of a broad phase.
pub type AsQueryPipeline<B> = for<'a> fn(
    &'a B,
    &'a dyn QueryDispatcher,
    &'a RigidBodySet,
    &'a ColliderSet,
    QueryFilter<'a>,
) -> QueryPipeline<'a>;

/// The tree of a broad phase, up to date.
pub(in super::super) fn tree_of<B>(broad_phase: &B, queries: AsQueryPipeline<B>) -> &Bvh {
    // What holds no bodies and no colliders is asked for nothing but the tree.
    static NOTHING: LazyLock<(RigidBodySet, ColliderSet)> = LazyLock::new(Default::default);
    let (bodies, colliders) = &*NOTHING;
    let filter = QueryFilter::default();
    queries(
        broad_phase,
        &DefaultQueryDispatcher,
        bodies,
        colliders,
        filter,
    )
    .bvh
}

impl World {
    /// A tree over all enabled colliders, for scenes whose broad phase cannot be asked. **O(n log n)**.
    pub(super) fn tree(&self) -> Bvh {
        let leaf = |(handle, collider): (ColliderHandle, &Collider)| {
            (handle.into_raw_parts().0 as usize, collider.compute_aabb())
        };
        let leaves: Vec<_> = self.colliders.iter_enabled().map(leaf).collect();
        // Parry builds trees of one and two leaves only if their indices are 0 and 1.
        if leaves.len() > 2 {
            return Bvh::from_iter(BvhBuildStrategy::Binned, leaves.into_iter());
        }
        let mut tree = Bvh::new();
        for (index, aabb) in leaves {
            tree.insert(aabb, index as u32);
        }
        tree
    }

    /// Queries about the colliders, as of the tree.
    pub(in super::super) fn queries<'a>(
        &'a self,
        tree: &'a Bvh,
        filter: QueryFilter<'a>,
    ) -> QueryPipeline<'a> {
        QueryPipeline {
            dispatcher: &DefaultQueryDispatcher,
            bvh: tree,
            bodies: &self.bodies,
            colliders: &self.colliders,
            filter,
        }
    }

    /// The same for a controller that pushes bodies.
    pub(in super::super) fn queries_mut<'a>(
        &'a mut self,
        tree: &'a Bvh,
        filter: QueryFilter<'a>,
    ) -> QueryPipelineMut<'a> {
        QueryPipelineMut {
            dispatcher: &DefaultQueryDispatcher,
            bvh: tree,
            bodies: &mut self.bodies,
            colliders: &mut self.colliders,
            filter,
        }
    }
}
