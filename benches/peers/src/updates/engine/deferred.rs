//! What Rapier 0.36.1 defers of an update: its tree is optimized after the pairs are found, beside the solver if there is
//! a thread for it (`PhysicsPipeline::join_deferred_bvh_optimize`), and otherwise before the next boxes are set. Without the
//! pipeline, the next update does it.
//!
//! The tree is copied, and the same is done to the copy. Whether there is anything to do is not to be asked from
//! outside, so it is decided here as in `broad_phase_bvh/update.rs`.

use super::frames::Frames;
use super::rapier::parry::partitioning::{Bvh, BvhWorkspace};
use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;
use std::time::Duration;

#[derive(Default)]
pub(super) struct Deferred {
    /// As it was after the last update.
    last: Option<Bvh>,
    workspace: BvhWorkspace,
    updates: u32,
    /// Leaves that were changed in place since the tree was last optimized.
    debt: usize,
    /// Whether leaves that change get another place.
    reinserts: bool,
}

impl Deferred {
    /// How long the next update will take for what the last one has deferred. Once after each update.
    pub(super) fn time(&mut self, broad_phase: &DefaultBroadPhase, frames: &Frames) -> Duration {
        let (bodies, colliders) = (&frames.world.bodies, &frames.world.colliders);
        let (dispatcher, filter) = (&DefaultQueryDispatcher, QueryFilter::default());
        let queries = broad_phase.as_query_pipeline(dispatcher, bodies, colliders, filter);
        if !self.is_due(queries.bvh, &frames.moving) {
            return Duration::ZERO;
        }
        let mut copy = queries.bvh.clone();
        let workspace = &mut self.workspace;
        frames.world.clock.time(|| {
            copy.optimize_incremental(workspace);
            copy.refit_without_resolve(workspace);
        })
    }

    fn is_due(&mut self, tree: &Bvh, moved: &[ColliderHandle]) -> bool {
        self.updates += 1;
        let leaves = tree.leaf_count() as usize;
        // The first update inserts all leaves, and owes nothing for that.
        let Some(last) = self.last.replace(tree.clone()) else {
            return false;
        };
        let box_in = |tree: &Bvh, index| tree.leaf_node(index).map(|leaf| leaf.aabb());
        let has_changed = |handle: &&ColliderHandle| {
            let index = handle.into_raw_parts().0;
            box_in(tree, index) != box_in(&last, index)
        };
        let changed = moved.iter().filter(has_changed).count();
        if !self.reinserts {
            self.debt += changed;
        }
        self.reinserts = changed * 16 < leaves;
        let is_due = self.debt > 0
            && (!self.reinserts || (self.updates.is_multiple_of(8) && self.debt * 64 >= leaves));
        if is_due {
            self.debt = 0;
        }
        is_due
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::{Case, Motion, Sizes};
    use crate::clock::Clock;

    /// The leaves in the order of the tree.
    fn order(tree: &DefaultBroadPhase, frames: &Frames) -> Vec<u32> {
        let (bodies, colliders) = (&frames.world.bodies, &frames.world.colliders);
        let (dispatcher, filter) = (&DefaultQueryDispatcher, QueryFilter::default());
        let queries = tree.as_query_pipeline(dispatcher, bodies, colliders, filter);
        queries.bvh.leaves(|_| true).collect()
    }

    /// Leaves change their order only when the tree is optimized, unless so few move that they get new places.
    #[test]
    fn time_is_told_apart_where_the_next_update_optimizes_the_tree() {
        for (motion, wanted) in [
            (Motion::OneIn(1), 20),
            (Motion::OneIn(10), 20),
            (Motion::InMargin, 1),
        ] {
            let case = Case {
                count: 2_000,
                density: 0.4,
                motion,
                sizes: Sizes::One,
                bodies: true,
                clock: Clock::Wall,
            };
            let mut tree = DefaultBroadPhase::new();
            let mut frames = Frames::new(&case, &mut tree);
            let mut deferred = Deferred::default();
            let mut times_optimized = 0;
            for frame in 0..24 {
                let before = order(&tree, &frames);
                let is_deferred = !deferred.time(&tree, &frames).is_zero();
                frames.advance(&mut tree);
                let is_optimized = order(&tree, &frames) != before;
                let name = motion.name();
                assert_eq!(is_deferred, is_optimized, "{name}, frame {frame}");
                times_optimized += usize::from(is_optimized);
            }
            assert!(times_optimized >= wanted, "{times_optimized}");
        }
    }
}
