//! Rapier 0.36, whose pipeline hands over the boxes of what the solver has moved, and then updates with lists of what
//! the user has changed, which are empty here.

use super::deferred::Deferred;
use super::ours::UnisizeBroadPhase;
use super::rapier::parry::partitioning::Bvh;
use super::rapier::parry::query::DefaultQueryDispatcher;
use super::rapier::prelude::*;
use super::world::{BroadPhaseOfEngine, Driven, World};
use crate::updates::peer::Entry;
use crate::updates::{BVH_036, OURS_HANDED_OVER};
use std::time::Duration;
use unisize::{PairFilter, Settings};

pub(crate) const OURS: Entry<DIM> = Entry {
    name: OURS_HANDED_OVER,
    ours: OURS_HANDED_OVER,
    create: |start| {
        Box::new(Driven::new(
            Handed::over_to(UnisizeBroadPhase::with_settings(
                // The level that leaves out what the default does, so that both hold the same pairs.
                Settings::default().with_filter(PairFilter::Groups),
            )),
            start,
        ))
    },
    takes_large: true,
};

pub(crate) const BVH: Entry<DIM> = Entry {
    name: BVH_036,
    ours: OURS_HANDED_OVER,
    create: |start| Box::new(Driven::new(Handed::over_to(BroadPhaseBvh::new()), start)),
    takes_large: true,
};

/// What takes boxes that are handed over.
trait TakesBoxes {
    /// The boxes of what has moved.
    fn set_boxes(&mut self, params: &IntegrationParameters, boxes: &[(ColliderHandle, Aabb)]);

    /// An update with the colliders that the user has changed.
    fn update_with(&mut self, world: &mut World, changed: &[ColliderHandle]);

    /// The tree that it goes on optimizing beside the solver.
    fn tree<'a>(&'a self, world: &'a World) -> Option<&'a Bvh>;
}

/// A broad phase, and what the engine has computed for it.
struct Handed<B> {
    broad_phase: B,
    /// The engine computes them for any broad phase, with the body at hand.
    boxes: Vec<(ColliderHandle, Aabb)>,
    deferred: Deferred,
}

impl<B> Handed<B> {
    fn over_to(broad_phase: B) -> Self {
        Self {
            broad_phase,
            boxes: Vec::new(),
            deferred: Deferred::default(),
        }
    }
}

impl<B: TakesBoxes> BroadPhaseOfEngine for Handed<B> {
    fn introduce(&mut self, world: &mut World) {
        // New colliders are changes by the user. This once, all the flags of change are set that the list calls
        // for; afterwards they would stay set, and would make the update insert anew what has only moved.
        let changed = world.listed.clone();
        self.broad_phase.update_with(world, &changed);
    }

    fn prepare(&mut self, world: &World) {
        // The same loosening as in the pipeline.
        let distance = world.params.prediction_distance() / 2.0;
        self.boxes.clear();
        self.boxes.extend(world.listed.iter().map(|&handle| {
            let aabb = world.colliders[handle].compute_collision_aabb(distance);
            (handle, aabb)
        }));
    }

    fn update(&mut self, world: &mut World) {
        self.broad_phase.set_boxes(&world.params, &self.boxes);
        self.broad_phase.update_with(world, &[]);
    }

    fn deferred(&mut self, world: &World) -> Duration {
        match self.broad_phase.tree(world) {
            Some(tree) => self.deferred.time(tree, &world.listed, world.clock),
            None => Duration::ZERO,
        }
    }
}

impl TakesBoxes for UnisizeBroadPhase {
    fn set_boxes(&mut self, params: &IntegrationParameters, boxes: &[(ColliderHandle, Aabb)]) {
        self.set_aabbs(params, boxes);
    }

    fn update_with(&mut self, world: &mut World, changed: &[ColliderHandle]) {
        self.update(
            &world.params,
            &world.colliders,
            &world.bodies,
            changed,
            &[],
            &mut world.events,
        );
    }

    fn tree<'a>(&'a self, _: &'a World) -> Option<&'a Bvh> {
        None
    }
}

impl TakesBoxes for BroadPhaseBvh {
    fn set_boxes(&mut self, params: &IntegrationParameters, boxes: &[(ColliderHandle, Aabb)]) {
        for (handle, aabb) in boxes {
            self.set_aabb(params, *handle, *aabb);
        }
    }

    fn update_with(&mut self, world: &mut World, changed: &[ColliderHandle]) {
        self.update(
            &world.params,
            &world.colliders,
            &world.bodies,
            changed,
            &[],
            &mut world.events,
        );
    }

    fn tree<'a>(&'a self, world: &'a World) -> Option<&'a Bvh> {
        let (bodies, colliders) = (&world.bodies, &world.colliders);
        let filter = QueryFilter::default();
        let queries = self.as_query_pipeline(&DefaultQueryDispatcher, bodies, colliders, filter);
        Some(queries.bvh)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pair_set::PairSet;
    use crate::updates::choreography::Choreography;
    use crate::updates::motion::Motion;
    use crate::updates::peer::Peer;
    use crate::updates::sizes::Sizes;

    fn start(motion: Motion) -> Choreography<DIM> {
        Choreography::new(2_000, 0.4, motion, Sizes::One)
    }

    #[test]
    fn what_takes_boxes_holds_all_pairs_that_overlap() {
        for motion in Motion::ALL {
            for entry in [OURS, BVH] {
                let mut now = start(motion);
                let mut peer = (entry.create)(&now);
                for _ in 0..30 {
                    now.advance();
                    peer.place(now.centers());
                    peer.update();
                }
                let overlapping = PairSet::of_boxes(&now.boxes(0.0)).expect("the boxes are sound");
                assert!(overlapping.len() > 100, "{}", entry.name);
                let missing = overlapping.missing_in(&peer.held_pairs());
                assert_eq!(missing, 0, "{}, {motion}", entry.name);
            }
        }
    }

    /// Leaves change their order only when the tree is optimized, unless so few move that they get new places.
    #[test]
    fn time_is_told_apart_where_the_next_update_optimizes_the_tree() {
        for motion in [Motion::OneIn(1), Motion::OneIn(10), Motion::InMargin] {
            let mut now = start(motion);
            let mut driven = Driven::new(Handed::over_to(BroadPhaseBvh::new()), &now);
            let order = |driven: &Driven<Handed<BroadPhaseBvh>>| {
                let tree = driven.broad_phase.broad_phase.tree(&driven.world);
                let tree = tree.expect("it is a tree");
                tree.leaves(|_| true).collect::<Vec<_>>()
            };
            let mut times_optimized = 0;
            for frame in 0..24 {
                now.advance();
                let before = order(&driven);
                let is_deferred = !driven.deferred().is_zero();
                driven.place(now.centers());
                driven.update();
                let is_optimized = order(&driven) != before;
                assert_eq!(is_deferred, is_optimized, "{motion}, frame {frame}");
                times_optimized += usize::from(is_optimized);
            }
            let wanted = match motion {
                Motion::InMargin => 1,
                _ => 20,
            };
            assert!(times_optimized >= wanted, "{motion}: {times_optimized}");
        }
    }
}
