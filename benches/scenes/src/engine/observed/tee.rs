//! Two broad phases in the place of one.

use super::super::rapier::prelude::*;
use super::super::version::{self, BroadPhase};

/// Two broad phases in the place of one. Both get each update with the same arguments, and Rapier gets the events of the first.
#[derive(Default)]
pub struct Tee<A, B> {
    /// The broad phase whose events go on to Rapier.
    pub heard: A,
    /// The other one.
    pub unheard: B,
    unheard_events: Vec<BroadPhasePairEvent>,
    updates: usize,
    is_unheard_first: bool,
    #[allow(dead_code)] // A step of Rapier 0.27 asks no tree.
    has_tree_of_unheard: bool,
}

impl<A: BroadPhase, B: BroadPhase> Tee<A, B> {
    /// Two broad phases that have seen no update yet, or the same ones.
    pub fn new(heard: A, unheard: B) -> Self {
        Self {
            heard,
            unheard,
            unheard_events: Vec::new(),
            updates: 0,
            is_unheard_first: false,
            has_tree_of_unheard: false,
        }
    }

    /// Lets a step ask the tree of the second broad phase. The first one still reports the pairs.
    pub fn with_tree_of_unheard(mut self) -> Self {
        self.has_tree_of_unheard = true;
        self
    }

    /// Begins with the second broad phase. The one that is second finds the colliders in the cache.
    pub fn with_unheard_first(mut self) -> Self {
        self.is_unheard_first = true;
        self
    }

    /// Which of the two is first. Most steps have two updates, of which only the second has much to do, so the order changes from step to
    /// step.
    fn is_heard_first(&self) -> bool {
        (self.updates.div_ceil(2) % 2 == 0) != self.is_unheard_first
    }

    /// Runs an update on both.
    fn update_both(
        &mut self,
        events: &mut Vec<BroadPhasePairEvent>,
        update: impl Fn(&mut dyn BroadPhase, &mut Vec<BroadPhasePairEvent>),
    ) {
        let is_heard_first = self.is_heard_first();
        self.updates += 1;
        self.unheard_events.clear();
        for is_heard in [is_heard_first, !is_heard_first] {
            let (broad_phase, events): (&mut dyn BroadPhase, _) = if is_heard {
                (&mut self.heard, &mut *events)
            } else {
                (&mut self.unheard, &mut self.unheard_events)
            };
            update(broad_phase, events);
        }
    }
}

impl<A: BroadPhase, B: BroadPhase> BroadPhase for Tee<A, B> {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.update_both(events, |broad_phase, events| {
            broad_phase.update(params, colliders, bodies, modified, removed, events);
        });
    }

    version::when_boxes_are_handed_over! {
        fn set_aabbs(&mut self, params: &IntegrationParameters, boxes: &[(ColliderHandle, Aabb)]) {
            // The one that was first in the last update, which reads colliders, is second here.
            if self.is_heard_first() {
                self.heard.set_aabbs(params, boxes);
                self.unheard.set_aabbs(params, boxes);
            } else {
                self.unheard.set_aabbs(params, boxes);
                self.heard.set_aabbs(params, boxes);
            }
        }

        fn update_in_pipeline(&mut self, input: &PipelineInput<'_>, events: &mut Vec<BroadPhasePairEvent>) {
            self.update_both(events, |broad_phase, events| {
                broad_phase.update_in_pipeline(input, events);
            });
        }

        fn visit_unreported(&self, visit: &mut dyn FnMut(ColliderHandle)) {
            self.heard.visit_unreported(visit);
        }

        fn bvh(&self) -> &Bvh {
            match self.has_tree_of_unheard {
                true => self.unheard.bvh(),
                false => self.heard.bvh(),
            }
        }

        // The copy is of the first one alone.
        fn clone_box(&self) -> Box<dyn BroadPhase> {
            self.heard.clone_box()
        }
    }
}
