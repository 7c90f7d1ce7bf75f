//! What the scenes need and Rapier 0.36 has in its own way: glam's vectors, soft bodies, and one type of broad phase, which
//! a patched copy lets be [custom](CustomBroadPhase). It hands over the boxes of what a step has moved.

use super::engine::queries::tree_of;
use super::engine::{AsQueryPipeline, Steppable, Tee, World};
use super::rapier::math;
use super::rapier::parry::partitioning::Bvh;
use super::rapier::prelude::*;
use super::soft::soft_body;
use std::marker::PhantomData;
use std::ops::{Deref, DerefMut};

pub(super) use super::rapier::dynamics::SoftBodySet;
pub use super::rapier::geometry::CustomBroadPhase as BroadPhase;

/// A vector.
pub type Vector = math::Vector;
/// A point.
pub type Point = math::Vector;
/// A place and a rotation.
pub type Pose = math::Pose;
/// An angular velocity, or a rotation as an angle or a scaled axis.
pub type AngVector = math::AngVector;

/// The pose at this place, without a rotation.
pub fn pose(place: Vector) -> Pose {
    Pose::from_translation(place)
}

/// The heights of a square field with so many corners on each side.
#[allow(dead_code)] // In the plane, a field has one row.
pub(super) fn square(side: usize, mut height: impl FnMut() -> Real) -> Array2<Real> {
    Array2::new(side, side, (0..side * side).map(|_| height()).collect())
}

/// The groups of a collider that meets another if each is a member of a group that the other filters for.
pub const fn groups(memberships: Group, filter: Group) -> InteractionGroups {
    InteractionGroups::new(memberships, filter, InteractionTestMode::And)
}

/// Whether the solver sees a contact of this pair.
pub fn touches(pair: &ContactPair) -> bool {
    pair.has_any_active_contact()
}

/// Whether a body stands for a soft one.
pub(super) fn is_soft(body: &RigidBody) -> bool {
    body.is_soft_frame()
}

/// A soft body is one body.
pub(super) const PARTS_OF_SOFT_BODY: usize = 1;

/// Inserts a soft body of this half size.
pub fn insert_soft_body(world: &mut World, center: Vector, half: Real) {
    let World {
        soft_bodies,
        bodies,
        colliders,
        ..
    } = world;
    soft_bodies.insert(soft_body(center, half), bodies, colliders);
}

/// What a step takes for a broad phase.
pub type AnyBroadPhase = DefaultBroadPhase;

impl Steppable for DefaultBroadPhase {
    fn for_step(&mut self) -> &mut AnyBroadPhase {
        self
    }
}

/// Rapier's own broad phase, as one that can be wrapped.
///
/// The pipeline runs part of an update later, beside the solver if it has threads. Here the next update does it.
#[derive(Clone, Default)]
pub struct OwnBroadPhase(DefaultBroadPhase);

impl OwnBroadPhase {
    /// Rapier's own broad phase without colliders.
    pub fn new() -> Self {
        Self::default()
    }
}

impl Deref for OwnBroadPhase {
    type Target = DefaultBroadPhase;

    fn deref(&self) -> &DefaultBroadPhase {
        &self.0
    }
}

impl BroadPhase for OwnBroadPhase {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.0
            .update(params, colliders, bodies, modified, removed, events);
    }

    fn set_aabb(&mut self, params: &IntegrationParameters, handle: ColliderHandle, aabb: Aabb) {
        self.0.set_aabb(params, handle, aabb);
    }

    fn bvh(&self) -> &Bvh {
        tree_of(&self.0, DefaultBroadPhase::as_query_pipeline)
    }

    fn clone_box(&self) -> Box<dyn BroadPhase> {
        Box::new(self.clone())
    }
}

/// A broad phase where a step takes it.
pub struct Installed<B>(DefaultBroadPhase, PhantomData<B>);

/// Puts a broad phase where a step takes it.
pub fn install<B: BroadPhase>(broad_phase: B) -> Installed<B> {
    Installed(DefaultBroadPhase::custom(broad_phase), PhantomData)
}

impl<B> Steppable for Installed<B> {
    fn for_step(&mut self) -> &mut AnyBroadPhase {
        &mut self.0
    }
}

impl<B: BroadPhase> Deref for Installed<B> {
    type Target = B;

    fn deref(&self) -> &B {
        self.0.custom_ref().expect("it was put there")
    }
}

impl<B: BroadPhase> DerefMut for Installed<B> {
    fn deref_mut(&mut self) -> &mut B {
        self.0.custom_mut().expect("it was put there")
    }
}

/// The tree of Rapier's own broad phase where it is wrapped.
pub fn own_tree(own: &OwnBroadPhase) -> &Bvh {
    own.bvh()
}

/// A broad phase whose pairs count, while a step asks the tree of Rapier's own, through which it sweeps fast bodies.
pub fn on_own_tree<B: BroadPhase>(broad_phase: B) -> Tee<B, OwnBroadPhase> {
    Tee::new(broad_phase, OwnBroadPhase::new()).with_tree_of_unheard()
}

/// A broad phase that is stepped with alone, and how it is asked: where a step takes it, as in a program that uses it.
pub(super) fn alone<B: BroadPhase>(
    broad_phase: B,
    _queries: AsQueryPipeline<B>,
) -> (DefaultBroadPhase, AsQueryPipeline<DefaultBroadPhase>) {
    let broad_phase = DefaultBroadPhase::custom(broad_phase);
    (broad_phase, DefaultBroadPhase::as_query_pipeline)
}

/// What this version asks of a broad phase beside updates.
macro_rules! when_boxes_are_handed_over {
    ($($item:item)*) => {
        $($item)*

        fn set_aabb(
            &mut self,
            params: &IntegrationParameters,
            handle: ColliderHandle,
            aabb: Aabb,
        ) {
            self.set_aabbs(params, &[(handle, aabb)]);
        }
    };
}
pub(super) use when_boxes_are_handed_over;

impl World {
    /// Advances the world by one time step.
    pub fn step(
        &mut self,
        broad_phase: &mut AnyBroadPhase,
        hooks: &dyn PhysicsHooks,
        events: &dyn EventHandler,
    ) {
        self.pipeline.step(
            self.gravity,
            &self.params,
            &mut self.islands,
            broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &mut self.impulse_joints,
            &mut self.multibody_joints,
            &mut self.soft_bodies,
            &mut self.ccd_solver,
            hooks,
            events,
        );
    }

    /// Runs one step of a collision pipeline, without dynamics.
    pub fn collide(&mut self, broad_phase: &mut AnyBroadPhase, events: &dyn EventHandler) {
        self.collision_pipeline.step(
            self.params.prediction_distance(),
            &mut self.islands,
            broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &(),
            events,
        );
    }

    /// Removes a collider, and wakes its neighbours.
    pub fn remove_collider(&mut self, handle: ColliderHandle) {
        let (islands, bodies) = (&mut self.islands, &mut self.bodies);
        let soft_bodies = &mut self.soft_bodies;
        self.colliders
            .remove(handle, islands, bodies, soft_bodies, true);
    }

    /// Removes a body with its colliders and joints.
    pub fn remove(&mut self, handle: RigidBodyHandle) {
        self.bodies.remove(
            handle,
            &mut self.islands,
            &mut self.colliders,
            &mut self.impulse_joints,
            &mut self.multibody_joints,
            &mut self.soft_bodies,
            true,
        );
    }
}
