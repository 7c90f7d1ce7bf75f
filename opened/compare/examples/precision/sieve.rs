//! A set of axes that unisize does not have, as a broad phase.

use super::dimension::is_left;
use super::ours::UnisizeBroadPhase;
use super::scenes::Observed;
use super::scenes::rapier::prelude::*;
use crate::Test;
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// Half of what two boxes with margins are apart when they part, in length units: the margin of Rapier 0.36.
const MARGIN: Real = 0.04;

/// Passes on the pairs of a broad phase that a test leaves: they begin when the shapes meet as of this step, and end when the boxes
/// part or the shapes are farther apart than both margins, as with `PairFilter::Shapes`. Without a test it passes on all.
pub(super) struct Sieve {
    pub(super) inner: Observed<UnisizeBroadPhase>,
    test: Option<Test>,
    /// The pairs of the broad phase, in the order of their events.
    near: BTreeMap<[u32; 2], Near>,
    /// The time that the test took in the last update.
    pub(super) spent: Duration,
}

#[derive(Clone)]
struct Near {
    pair: ColliderPair,
    is_passed_on: bool,
}

impl Sieve {
    pub(super) fn new(inner: UnisizeBroadPhase, test: Option<Test>) -> Self {
        Self {
            inner: Observed::new(inner).clocked(),
            test,
            near: BTreeMap::new(),
            spent: Duration::ZERO,
        }
    }

    /// Follows the events of the broad phase, and puts its own in their place.
    fn sift(
        &mut self,
        test: Test,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.near.retain(|_, near| {
            let mut both = [near.pair.collider1, near.pair.collider2].into_iter();
            both.all(|handle| colliders.contains(handle))
        });
        let (mut ended, mut begun) = (BTreeMap::new(), Vec::new());
        for event in events.drain(..) {
            match event {
                BroadPhasePairEvent::AddPair(pair) => {
                    let near = Near {
                        pair,
                        is_passed_on: false,
                    };
                    self.near.insert(key(pair), near);
                }
                BroadPhasePairEvent::DeletePair(pair) => {
                    if self
                        .near
                        .remove(&key(pair))
                        .is_some_and(|near| near.is_passed_on)
                    {
                        ended.insert(key(pair), pair);
                    }
                }
            }
        }
        for (&key, near) in &mut self.near {
            let Near { pair, is_passed_on } = near;
            let both = [pair.collider1, pair.collider2].map(|handle| &colliders[handle]);
            let margins = if *is_passed_on {
                2.0 * MARGIN * params.length_unit
            } else {
                0.0
            };
            let was_passed_on = *is_passed_on;
            *is_passed_on = is_left(test, both, params.prediction_distance() + margins);
            match (was_passed_on, *is_passed_on) {
                (false, true) => begun.push(*pair),
                (true, false) => drop(ended.insert(key, *pair)),
                _ => {}
            }
        }
        events.extend(ended.into_values().map(BroadPhasePairEvent::DeletePair));
        events.extend(begun.into_iter().map(BroadPhasePairEvent::AddPair));
    }
}

fn key(pair: ColliderPair) -> [u32; 2] {
    [pair.collider1, pair.collider2].map(|handle| handle.into_raw_parts().0)
}

impl CustomBroadPhase for Sieve {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let mut own = Vec::new();
        self.inner
            .update(params, colliders, bodies, modified, removed, &mut own);
        let start = Instant::now();
        if let Some(test) = self.test {
            self.sift(test, params, colliders, &mut own);
        }
        self.spent = start.elapsed();
        events.append(&mut own);
    }

    fn note_changes(&mut self, reinserted: &[ColliderHandle], unmoved: &[ColliderHandle]) {
        self.inner.note_changes(reinserted, unmoved);
    }

    fn set_aabb(&mut self, params: &IntegrationParameters, handle: ColliderHandle, aabb: Aabb) {
        self.inner.set_aabb(params, handle, aabb);
    }

    fn set_aabbs(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        aabbs: &[(ColliderHandle, Aabb)],
    ) {
        self.inner.set_aabbs(params, colliders, aabbs);
    }

    fn bvh(&self) -> &Bvh {
        self.inner.bvh()
    }

    fn clone_box(&self) -> Box<dyn CustomBroadPhase> {
        // The copy has a clock of its own.
        Box::new(Self {
            near: self.near.clone(),
            ..Self::new(self.inner.inner.clone(), self.test)
        })
    }
}
