//! A method at work: a broad phase and a narrow phase of its own, in a world that another simulation moves.

use super::broad_phases::AnyBroadPhase;
use super::scenes::rapier::prelude::*;
use super::scenes::{Observed, World};
use cpu_time::ThreadTime;
use std::time::Duration;

/// A broad phase and a narrow phase of its own.
pub(super) struct Contestant {
    broad_phase: Ended,
    narrow_phase: NarrowPhase,
    pipeline: CollisionPipeline,
}

/// How long a step took, in processor time.
#[derive(Clone, Copy)]
pub(super) struct Lap {
    pub(super) broad: Duration,
    pub(super) both: Duration,
}

impl Contestant {
    pub(super) fn new(broad_phase: Observed<AnyBroadPhase>, records_pairs: bool) -> Self {
        Self {
            broad_phase: Ended {
                inner: match records_pairs {
                    true => broad_phase.with_held(),
                    false => broad_phase,
                },
                end: Duration::ZERO,
            },
            narrow_phase: NarrowPhase::new(),
            pipeline: CollisionPipeline::new(),
        }
    }

    /// Finds the contacts of a copy of the world in which these colliders have moved.
    ///
    /// The time of the narrow phase includes Rapier's handling of changes by the user, which is short: there are none.
    pub(super) fn step(&mut self, stage: &mut Stage, moved: &[ColliderHandle]) -> Lap {
        stage.mark(moved);
        self.pipeline.step(
            stage.prediction,
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut stage.bodies,
            &mut stage.colliders,
            &JointFilter(&stage.joints),
            &(),
        );
        let narrow = ThreadTime::now().as_duration() - self.broad_phase.end;
        let broad = self.broad_phase().inner.last;
        Lap {
            broad,
            both: broad + narrow,
        }
    }

    pub(super) fn broad_phase(&self) -> &Observed<AnyBroadPhase> {
        &self.broad_phase.inner
    }
}

/// A broad phase that notes when it was over, and all that is observed had been taken down.
struct Ended {
    inner: Observed<AnyBroadPhase>,
    /// The processor time of the thread at the end of the last update.
    end: Duration,
}

impl BroadPhase for Ended {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.inner
            .update(params, colliders, bodies, modified, removed, events);
        self.end = ThreadTime::now().as_duration();
    }
}

/// A copy of a world at one step, for all contestants.
pub(super) struct Stage {
    pub(super) colliders: ColliderSet,
    pub(super) bodies: RigidBodySet,
    joints: ImpulseJointSet,
    prediction: Real,
}

impl Stage {
    pub(super) fn of(world: &World) -> Self {
        Self {
            colliders: world.colliders.clone(),
            bodies: world.bodies.clone(),
            joints: world.impulse_joints.clone(),
            prediction: world.params.prediction_distance(),
        }
    }

    /// Has Rapier handle what was changed by hand, so that no contestant has to.
    pub(super) fn settle(&mut self) {
        CollisionPipeline::new().step(
            self.prediction,
            &mut Nothing,
            &mut NarrowPhase::new(),
            &mut self.bodies,
            &mut self.colliders,
            &(),
            &(),
        );
    }

    /// Marks these colliders, and no others, as moved.
    fn mark(&mut self, moved: &[ColliderHandle]) {
        for &handle in moved {
            if let Some(collider) = self.colliders.get_mut(handle) {
                let position = *collider.position();
                collider.set_position(position);
                if !self.joints.is_empty() {
                    collider.set_active_hooks(ActiveHooks::FILTER_CONTACT_PAIRS);
                }
            }
        }
    }
}

/// A broad phase that finds nothing.
struct Nothing;

impl BroadPhase for Nothing {
    fn update(
        &mut self,
        _: &IntegrationParameters,
        _: &ColliderSet,
        _: &RigidBodySet,
        _: &[ColliderHandle],
        _: &[ColliderHandle],
        _: &mut Vec<BroadPhasePairEvent>,
    ) {
    }
}

/// Leaves out the contacts that joints disable, as `PhysicsPipeline` does and `CollisionPipeline`, which knows of no
/// joints, does not.
struct JointFilter<'a>(&'a ImpulseJointSet);

impl PhysicsHooks for JointFilter<'_> {
    fn filter_contact_pair(&self, context: &PairFilterContext<'_>) -> Option<SolverFlags> {
        let bodies = context.rigid_body1.zip(context.rigid_body2);
        let is_disabled = bodies.is_some_and(|(first, second)| {
            let mut joints = self.0.joints_between(first, second);
            joints.any(|(_, joint)| !joint.data.contacts_enabled)
        });
        (!is_disabled).then(SolverFlags::default)
    }
}
