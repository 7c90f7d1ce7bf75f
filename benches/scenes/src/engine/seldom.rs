//! A broad phase that is updated only in every n-th step. It keeps its pairs in between, and the simulation goes on with them.

use super::rapier::prelude::*;
use super::version::{self, BroadPhase};

/// A broad phase that is updated only in every n-th step.
#[derive(Clone)]
pub struct Seldom<B> {
    inner: B,
    interval: usize,
    /// The number of updates that listed a collider or followed new boxes.
    busy: usize,
    /// The colliders that were modified since the last update.
    pending: Vec<ColliderHandle>,
    /// Whether boxes were passed since the last update.
    has_boxes: bool,
}

impl<B> Seldom<B> {
    /// Updates the broad phase in every `interval`-th step that has something to update.
    pub fn new(inner: B, interval: usize) -> Self {
        Self {
            inner,
            interval,
            busy: 0,
            pending: Vec::new(),
            has_boxes: false,
        }
    }
}

impl<B: BroadPhase> Seldom<B> {
    /// Runs an update if one is due, with all colliders that were modified since the last one.
    fn update_if_due(
        &mut self,
        [modified, removed]: [&[ColliderHandle]; 2],
        update: impl FnOnce(&mut B, &[ColliderHandle]),
    ) {
        self.pending.extend(modified);
        let is_busy = !modified.is_empty() || std::mem::take(&mut self.has_boxes);
        let is_due = is_busy && self.busy % self.interval == 0;
        self.busy += usize::from(is_busy);
        // No pair of a removed collider may stay.
        if is_due || !removed.is_empty() {
            self.pending
                .sort_unstable_by_key(|handle| handle.into_raw_parts());
            self.pending.dedup();
            let pending = std::mem::take(&mut self.pending);
            update(&mut self.inner, &pending);
        }
    }
}

impl<B: BroadPhase + Clone + 'static> BroadPhase for Seldom<B> {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.update_if_due([modified, removed], |inner, modified| {
            inner.update(params, colliders, bodies, modified, removed, events);
        });
    }

    version::when_boxes_are_handed_over! {
        fn set_aabbs(&mut self, params: &IntegrationParameters, boxes: &[(ColliderHandle, Aabb)]) {
            self.has_boxes |= !boxes.is_empty();
            self.inner.set_aabbs(params, boxes);
        }

        fn update_in_pipeline(&mut self, input: &PipelineInput<'_>, events: &mut Vec<BroadPhasePairEvent>) {
            self.update_if_due([input.modified, input.removed], |inner, modified| {
                let mut input = *input;
                input.modified = modified;
                inner.update_in_pipeline(&input, events);
            });
        }

        fn visit_unreported(&self, visit: &mut dyn FnMut(ColliderHandle)) {
            self.inner.visit_unreported(visit);
        }

        fn bvh(&self) -> &Bvh {
            self.inner.bvh()
        }

        fn clone_box(&self) -> Box<dyn BroadPhase> {
            Box::new(self.clone())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::observed::Observed;
    use super::super::rapier::prelude::*;
    use super::super::space::{Vector, along};
    use super::super::version::{OwnBroadPhase, install};
    use super::super::world::{Steppable, World};
    use super::Seldom;

    /// The steps at which the pair of two balls that fly through each other is held.
    fn held(interval: usize) -> Vec<bool> {
        let mut world = World::new(Vector::default());
        for side in [-1.0, 1.0] {
            let ball = ColliderBuilder::ball(0.5).sensor(true);
            let body = RigidBodyBuilder::dynamic()
                .translation(along(0, 0.9 * side))
                .linvel(along(0, -12.0 * side));
            world.insert(body, ball);
        }
        let seldom = Seldom::new(OwnBroadPhase::new(), interval);
        let mut broad_phase = install(Observed::new(seldom).with_held());
        let step = |_| {
            world.step(broad_phase.for_step(), &(), &());
            !broad_phase.held().is_empty()
        };
        (0..12).map(step).collect()
    }

    #[test]
    fn pairs_come_late_and_stay_long() {
        let often = held(1);
        let first = |held: &[bool]| held.iter().position(|&held| held).expect("they meet");
        for interval in [2, 3] {
            let seldom = held(interval);
            let late = first(&seldom) - first(&often);
            assert!((0..interval).contains(&late), "{often:?} {seldom:?}");
            // Two updates in a row are never different.
            let changes: Vec<_> = (1..12).filter(|&i| seldom[i] != seldom[i - 1]).collect();
            let apart = changes
                .windows(2)
                .all(|pair| (pair[1] - pair[0]) % interval == 0);
            assert!(apart, "{seldom:?}");
        }
    }
}
