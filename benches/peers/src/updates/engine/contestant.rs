//! A broad phase in a world of its own: one source, compiled once for each version of Rapier and each dimension.

use super::engine::Driven;
use super::frames::Frames;
use super::rapier::prelude::*;
use crate::case::Case;
use crate::pair_set::PairSet;
use crate::updates::Peer;
use std::collections::HashSet;
use std::time::Duration;

/// A broad phase, and all that it has said.
pub(super) struct Contestant<B, F> {
    broad_phase: B,
    pub(super) frames: Frames,
    log: Vec<BroadPhasePairEvent>,
    /// How much of the next update is only there because this thread has no other to do it beside the solver.
    deferred: F,
}

impl<B: Driven, F: FnMut(&B, &Frames) -> Duration> Contestant<B, F> {
    /// With all colliders known to the broad phase.
    pub(super) fn new(case: &Case, mut broad_phase: B, deferred: F) -> Self {
        let mut frames = Frames::new(case, &mut broad_phase);
        let log = std::mem::take(&mut frames.world.events);
        Self {
            broad_phase,
            frames,
            log,
            deferred,
        }
    }
}

/// Of one that defers nothing.
pub(super) fn nothing<B>(_: &B, _: &Frames) -> Duration {
    Duration::ZERO
}

impl<B: Driven, F: FnMut(&B, &Frames) -> Duration> Peer<DIM> for Contestant<B, F> {
    fn advance(&mut self) -> Duration {
        let time = self.frames.advance(&mut self.broad_phase);
        self.log.append(&mut self.frames.world.events);
        time
    }

    fn deferred(&mut self) -> Duration {
        (self.deferred)(&self.broad_phase, &self.frames)
    }

    fn held_pairs(&self) -> PairSet {
        // The two of a pair may come in either order.
        let indices = |pair: &ColliderPair| {
            let pair = [pair.collider1, pair.collider2];
            let [a, b] = pair.map(|collider| collider.into_raw_parts().0);
            [a.min(b), a.max(b)]
        };
        let mut held = HashSet::new();
        for event in &self.log {
            match event {
                BroadPhasePairEvent::AddPair(pair) => held.insert(indices(pair)),
                BroadPhasePairEvent::DeletePair(pair) => held.remove(&indices(pair)),
            };
        }
        PairSet::new(held)
    }

    fn boxes(&self) -> Vec<unisize::Aabb<f32, DIM>> {
        let around = |(_, collider): (_, &Collider)| {
            let aabb = collider.compute_aabb();
            unisize::Aabb::new(
                std::array::from_fn(|k| aabb.mins[k]),
                std::array::from_fn(|k| aabb.maxs[k]),
            )
        };
        self.frames.world.colliders.iter().map(around).collect()
    }
}
