//! Scene queries: rays, points and shapes against the colliders.
//!
//! Rapier's queries go to the tree of its own broad phase. Here there is no tree until the first query, and then one
//! that is kept (`query_tree.rs`).

use super::UnisizeBroadPhase;
use super::rapier::dynamics::RigidBodySet;
use super::rapier::geometry::ColliderSet;
use super::rapier::parry::partitioning::Bvh;
use super::rapier::parry::query::QueryDispatcher;
use super::rapier::pipeline::{QueryFilter, QueryPipeline, QueryPipelineMut};

impl UnisizeBroadPhase {
    /// The scene as of the last update, for queries. The counterpart of `BroadPhaseBvh::as_query_pipeline`.
    ///
    /// The first call builds a tree in **O(n log n)**, which is kept as long as there are calls. The first call after an
    /// update brings it up to date, in well under a tenth of that time; further calls are free.
    ///
    /// Its boxes are those of Rapier's own broad phase, and so are the answers.
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

    pub(crate) fn tree(&self) -> &Bvh {
        self.query_tree.of(self.table.boxes(), self.table.touched())
    }
}
