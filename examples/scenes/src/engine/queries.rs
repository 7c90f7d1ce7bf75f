//! What may be asked of a broad phase: rays, shapes and points against the colliders.
//!
//! Rapier's `BroadPhase` trait has no queries; each broad phase has two functions of the same names instead.
//! [`QueryAccess`] holds them, so that scenes can ask any broad phase that has them.

use super::rapier::parry::partitioning::{Bvh, BvhBuildStrategy};
use super::rapier::parry::query::{DefaultQueryDispatcher, QueryDispatcher};
use super::rapier::prelude::*;

/// Whatever answers queries about the colliders, as of the last step.
pub trait Queries {
    /// The query pipeline.
    fn pipeline<'a>(
        &'a self,
        bodies: &'a RigidBodySet,
        colliders: &'a ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipeline<'a>;

    /// The query pipeline of a controller that pushes bodies.
    fn pipeline_mut<'a>(
        &'a self,
        bodies: &'a mut RigidBodySet,
        colliders: &'a mut ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipelineMut<'a>;
}

/// The function `as_query_pipeline` of a broad phase.
type AsQueryPipeline<B> = for<'a> fn(
    &'a B,
    &'a dyn QueryDispatcher,
    &'a RigidBodySet,
    &'a ColliderSet,
    QueryFilter<'a>,
) -> QueryPipeline<'a>;

/// The function `as_query_pipeline_mut` of a broad phase.
type AsQueryPipelineMut<B> = for<'a> fn(
    &'a B,
    &'a dyn QueryDispatcher,
    &'a mut RigidBodySet,
    &'a mut ColliderSet,
    QueryFilter<'a>,
) -> QueryPipelineMut<'a>;

/// How a broad phase is asked.
///
/// ```
/// # #[cfg(feature = "rapier3d-027")]
/// # {
/// use unisize_scenes::dim3::{QueryAccess, rapier::prelude::DefaultBroadPhase};
///
/// let access = QueryAccess::new(
///     DefaultBroadPhase::as_query_pipeline,
///     DefaultBroadPhase::as_query_pipeline_mut,
/// );
/// # }
/// ```
pub struct QueryAccess<B> {
    shared: AsQueryPipeline<B>,
    exclusive: AsQueryPipelineMut<B>,
}

impl<B> QueryAccess<B> {
    /// Access through these functions of the broad phase.
    pub fn new(shared: AsQueryPipeline<B>, exclusive: AsQueryPipelineMut<B>) -> Self {
        Self { shared, exclusive }
    }

    /// The queries of this broad phase.
    pub fn to<'b>(&self, broad_phase: &'b B) -> impl Queries + use<'b, B> {
        Access {
            broad_phase,
            access: *self,
        }
    }
}

impl<B> Clone for QueryAccess<B> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<B> Copy for QueryAccess<B> {}

struct Access<'b, B> {
    broad_phase: &'b B,
    access: QueryAccess<B>,
}

impl<B> Queries for Access<'_, B> {
    fn pipeline<'a>(
        &'a self,
        bodies: &'a RigidBodySet,
        colliders: &'a ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipeline<'a> {
        (self.access.shared)(
            self.broad_phase,
            &DefaultQueryDispatcher,
            bodies,
            colliders,
            filter,
        )
    }

    fn pipeline_mut<'a>(
        &'a self,
        bodies: &'a mut RigidBodySet,
        colliders: &'a mut ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipelineMut<'a> {
        (self.access.exclusive)(
            self.broad_phase,
            &DefaultQueryDispatcher,
            bodies,
            colliders,
            filter,
        )
    }
}

/// A tree over all enabled colliders, for scenes whose broad phase cannot be asked.
pub(super) struct OwnTree(Bvh);

impl OwnTree {
    /// Builds the tree in **O(n log n)** time.
    pub(super) fn of(colliders: &ColliderSet) -> Self {
        let mut leaves: Vec<_> = colliders
            .iter_enabled()
            .map(|(handle, collider)| (handle.into_raw_parts().0 as usize, collider.compute_aabb()))
            .collect();
        // Parry builds trees of one and two leaves only if their indices are 0 and 1.
        if leaves.len() > 2 {
            return Self(Bvh::from_iter(BvhBuildStrategy::Binned, leaves.drain(..)));
        }
        let mut tree = Bvh::new();
        for (index, aabb) in leaves {
            tree.insert(aabb, index as u32);
        }
        Self(tree)
    }
}

impl Queries for OwnTree {
    fn pipeline<'a>(
        &'a self,
        bodies: &'a RigidBodySet,
        colliders: &'a ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipeline<'a> {
        QueryPipeline {
            dispatcher: &DefaultQueryDispatcher,
            bvh: &self.0,
            bodies,
            colliders,
            filter,
        }
    }

    fn pipeline_mut<'a>(
        &'a self,
        bodies: &'a mut RigidBodySet,
        colliders: &'a mut ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipelineMut<'a> {
        QueryPipelineMut {
            dispatcher: &DefaultQueryDispatcher,
            bvh: &self.0,
            bodies,
            colliders,
            filter,
        }
    }
}
