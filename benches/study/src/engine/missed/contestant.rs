//! A method at work: a broad phase and a narrow phase of its own, in a world that another simulation moves.

use super::Created;
use super::scenes::rapier::prelude::*;
use super::scenes::{BroadPhase, PairEvent, World};
use cpu_time::ThreadTime;
use std::collections::HashSet;
use std::time::Duration;

/// A broad phase and a narrow phase of its own.
pub(super) struct Contestant {
    broad_phase: OfMethod,
    narrow_phase: NarrowPhase,
    pipeline: CollisionPipeline,
    held: HashSet<[(u32, u32); 2]>,
}

impl Contestant {
    pub(super) fn new(broad_phase: Created) -> Self {
        Self {
            broad_phase: OfMethod {
                inner: broad_phase,
                events: Vec::new(),
            },
            narrow_phase: NarrowPhase::new(),
            pipeline: CollisionPipeline::new(),
            held: HashSet::new(),
        }
    }

    /// Finds the contacts of a copy of the world in which these colliders have moved, and returns the processor time of that.
    ///
    /// The time includes Rapier's handling of changes by the user, which is short: there are none.
    pub(super) fn step(&mut self, stage: &mut Stage, moved: &[ColliderHandle]) -> Duration {
        stage.mark(moved);
        let start = ThreadTime::now();
        self.pipeline.step(
            stage.prediction,
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut stage.bodies,
            &mut stage.colliders,
            &JointFilter(&stage.joints),
            &(),
        );
        let time = start.elapsed();
        for event in self.broad_phase.events.drain(..) {
            match event {
                PairEvent::Add(pair) => self.held.insert(ends(pair)),
                PairEvent::Delete(pair) => self.held.remove(&ends(pair)),
            };
        }
        time
    }

    /// How many of these pairs it does not hold.
    pub(super) fn missed(&self, pairs: &[ColliderPair]) -> usize {
        let missed = pairs.iter().filter(|&&pair| !self.held.contains(&ends(pair)));
        missed.count()
    }

    /// How many pairs it holds.
    pub(super) fn held(&self) -> usize {
        self.held.len()
    }
}

/// The broad phase of a method, and the events of its last update.
struct OfMethod {
    inner: Created,
    events: Vec<PairEvent>,
}

impl BroadPhase for OfMethod {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let inner = self.inner.for_step();
        inner.update(params, colliders, bodies, modified, removed, events);
        self.events.extend(events.iter().map(PairEvent::from));
    }
}

/// The two ends of a pair, whichever comes first.
fn ends(pair: ColliderPair) -> [(u32, u32); 2] {
    let mut ends = [pair.collider1, pair.collider2].map(ColliderHandle::into_raw_parts);
    ends.sort_unstable();
    ends
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
