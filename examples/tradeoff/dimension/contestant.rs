//! A method at work: a broad phase and a narrow phase of its own, in a world that another simulation moves.

use super::broad_phases::{self, AnyBroadPhase};
use super::scenes::rapier::prelude::*;
use super::scenes::{Observed, World};
use crate::method::Method;
use std::time::Duration;

/// A broad phase and a narrow phase of its own.
pub(super) struct Contestant {
    pub(super) broad_phase: Observed<AnyBroadPhase>,
    narrow_phase: NarrowPhase,
    pipeline: CollisionPipeline,
}

/// How long a step took.
#[derive(Clone, Copy)]
pub(super) struct Lap {
    pub(super) broad: Duration,
    pub(super) both: Duration,
}

impl Contestant {
    pub(super) fn new(method: Method, typical_size: Real, records_pairs: bool) -> Self {
        let clocked = broad_phases::create(method, typical_size).clocked();
        Self {
            broad_phase: if records_pairs {
                clocked.with_held()
            } else {
                clocked
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
        let timing = self.broad_phase.timing();
        let narrow = timing.end.map_or(Duration::ZERO, |end| end.elapsed());
        Lap {
            broad: timing.last,
            both: timing.last + narrow,
        }
    }
}

/// A copy of a world at one step, for all contestants.
pub(super) struct Stage {
    colliders: ColliderSet,
    bodies: RigidBodySet,
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
