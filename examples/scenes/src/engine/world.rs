//! Everything that `PhysicsPipeline::step` asks for, except the broad phase.

use super::rapier::prelude::*;
use super::version::{SoftBodySet, Vector};

/// A Rapier world without its broad phase, which is given to each step.
pub struct World {
    /// The acceleration of every dynamic body, in length units per second squared.
    pub gravity: Vector,
    /// The time step and the solver's settings.
    pub params: IntegrationParameters,
    /// Scratch memory of the step, and its timings.
    pub pipeline: PhysicsPipeline,
    /// Which bodies are awake.
    pub islands: IslandManager,
    /// The contacts and intersections.
    pub narrow_phase: NarrowPhase,
    /// The bodies.
    pub bodies: RigidBodySet,
    /// The colliders.
    pub colliders: ColliderSet,
    /// The joints between bodies.
    pub impulse_joints: ImpulseJointSet,
    /// The joints in reduced coordinates.
    pub multibody_joints: MultibodyJointSet,
    /// The soft bodies, in versions that have them.
    pub soft_bodies: SoftBodySet,
    /// The solver for bodies with CCD.
    pub ccd_solver: CCDSolver,
}

impl World {
    /// An empty world with this gravity.
    pub fn new(gravity: Vector) -> Self {
        Self {
            gravity,
            params: IntegrationParameters::default(),
            pipeline: PhysicsPipeline::new(),
            islands: IslandManager::new(),
            narrow_phase: NarrowPhase::new(),
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            impulse_joints: ImpulseJointSet::new(),
            multibody_joints: MultibodyJointSet::new(),
            soft_bodies: SoftBodySet::default(),
            ccd_solver: CCDSolver::new(),
        }
    }

    /// Inserts a body with one collider.
    pub fn insert(
        &mut self,
        body: impl Into<RigidBody>,
        collider: impl Into<Collider>,
    ) -> RigidBodyHandle {
        let handle = self.bodies.insert(body);
        self.colliders
            .insert_with_parent(collider, handle, &mut self.bodies);
        handle
    }

    /// Whether the narrow phase would look at a pair of colliders of this world at all.
    ///
    /// The conditions are those of `NarrowPhase::compute_contacts` and `compute_intersections` without hooks and joints:
    /// not of one body, and of types and groups that meet.
    pub fn may_touch(&self, a: &Collider, b: &Collider) -> bool {
        let body_type = |collider: &Collider| {
            collider
                .parent()
                .map_or(RigidBodyType::Fixed, |body| self.bodies[body].body_type())
        };
        let types = [body_type(a), body_type(b)];
        let same_parent = a.parent().is_some() && a.parent() == b.parent();
        let types_meet = |collider: &Collider| {
            let active = collider.active_collision_types();
            active.test(types[0], types[1])
        };
        !same_parent
            && (types_meet(a) || types_meet(b))
            && a.collision_groups().test(b.collision_groups())
    }
}
