//! Everything that `PhysicsPipeline::step` asks for, except the broad phase.

use super::rapier::prelude::*;
use super::version::{self, AnyBroadPhase, SoftBodySet, Vector};

/// A broad phase that a world can be stepped with.
pub trait Steppable {
    /// What a step takes.
    fn for_step(&mut self) -> &mut AnyBroadPhase;
}

/// A Rapier world without its broad phase, which is given to each step.
pub struct World {
    /// The acceleration of every dynamic body, in length units per second squared.
    pub gravity: Vector,
    /// The time step and the solver's settings.
    pub params: IntegrationParameters,
    /// Scratch memory of the step, and its timings.
    pub pipeline: PhysicsPipeline,
    /// Scratch memory of what detects collisions without dynamics.
    pub collision_pipeline: CollisionPipeline,
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

/// The clone has scratch memory of its own.
impl Clone for World {
    #[allow(
        clippy::clone_on_copy,
        clippy::unit_arg,
        reason = "Rapier 0.27 has no soft bodies"
    )]
    fn clone(&self) -> Self {
        Self {
            gravity: self.gravity,
            params: self.params,
            pipeline: PhysicsPipeline::new(),
            collision_pipeline: CollisionPipeline::new(),
            islands: self.islands.clone(),
            narrow_phase: self.narrow_phase.clone(),
            bodies: self.bodies.clone(),
            colliders: self.colliders.clone(),
            impulse_joints: self.impulse_joints.clone(),
            multibody_joints: self.multibody_joints.clone(),
            soft_bodies: self.soft_bodies.clone(),
            ccd_solver: self.ccd_solver.clone(),
        }
    }
}

impl World {
    /// An empty world with this gravity.
    pub fn new(gravity: Vector) -> Self {
        Self {
            gravity,
            params: IntegrationParameters::default(),
            pipeline: PhysicsPipeline::new(),
            collision_pipeline: CollisionPipeline::new(),
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

    /// Has all colliders told to the next broad phase, though none has moved.
    pub fn touch_all(&mut self) {
        for (_, collider) in self.colliders.iter_mut() {
            collider.set_position(*collider.position());
        }
    }

    /// How many pairs the narrow phase holds of which nothing comes: no active contact, and no intersection.
    pub fn pairs_without_contact(&self) -> usize {
        let contacts = self.narrow_phase.contact_pairs();
        let intersections = self.narrow_phase.intersection_pairs();
        contacts.filter(|pair| !version::touches(pair)).count()
            + intersections.filter(|&(_, _, is_real)| !is_real).count()
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

#[cfg(test)]
mod tests {
    use super::super::space::along;
    use super::*;

    #[test]
    fn pairs_are_without_contact_while_only_boxes_overlap() {
        let mut world = World::new(Vector::default());
        let mut broad_phase = DefaultBroadPhase::new();
        let ball =
            || ColliderBuilder::ball(1.0).active_collision_types(ActiveCollisionTypes::all());
        world.insert(RigidBodyBuilder::fixed(), ball());
        let body = world.insert(RigidBodyBuilder::kinematic_position_based(), ball());
        let collider = world.bodies[body].colliders()[0];
        for is_sensor in [false, true] {
            world.colliders[collider].set_sensor(is_sensor);
            for (height, pairs) in [(0.0, 0), (1.6, 1), (3.2, 0)] {
                let place = along(0, 1.6) + along(1, height);
                world.bodies[body].set_translation(place, true);
                world.step(&mut broad_phase, &(), &());
                let found = world.pairs_without_contact();
                assert_eq!(found, pairs, "sensor: {is_sensor}, at {height}");
            }
        }
    }
}
