//! What the scenes need and Rapier 0.27 has in its own way: nalgebra's vectors, and a trait for broad phases.

use super::engine::queries::tree_of;
use super::engine::{AsQueryPipeline, Steppable, World};
use super::rapier::math::{self, Isometry};
use super::rapier::na::DMatrix;
use super::rapier::parry::partitioning::Bvh;
use super::rapier::prelude::*;

pub use super::rapier::geometry::BroadPhase;

/// A vector.
pub type Vector = math::Vector<Real>;
/// A point.
pub type Point = math::Point<Real>;
/// A place and a rotation.
pub type Pose = Isometry<Real>;
/// An angular velocity, or a rotation as an angle or a scaled axis.
pub type AngVector = math::AngVector<Real>;

/// There are no soft bodies yet.
pub(super) type SoftBodySet = ();

/// The pose at this place, without a rotation.
pub fn pose(place: Vector) -> Pose {
    Pose::from(place)
}

/// The heights of a square field with so many corners on each side.
#[allow(dead_code)] // In the plane, a field has one row.
pub(super) fn square(side: usize, mut height: impl FnMut() -> Real) -> DMatrix<Real> {
    DMatrix::from_fn(side, side, |_, _| height())
}

/// The groups of a collider that meets another if each is a member of a group that the other filters for.
pub const fn groups(memberships: Group, filter: Group) -> InteractionGroups {
    InteractionGroups::new(memberships, filter)
}

/// Whether the solver sees a contact of this pair.
pub fn touches(pair: &ContactPair) -> bool {
    pair.has_any_active_contact
}

/// Whether a body stands for a soft one.
pub(super) fn is_soft(_: &RigidBody) -> bool {
    false
}

/// How many bodies what comes closest to a soft body is made of.
pub(super) const PARTS_OF_SOFT_BODY: usize = 1 << DIM;

/// Inserts what comes closest to a soft body of this half size: balls at the corners of a cube, each on springs to all
/// others.
pub(super) fn insert_soft_body(world: &mut World, center: Vector, half: Real) {
    // Overdamped ones would pull the balls through the rest in a step.
    const STIFFNESS: Real = 200.0;
    const DAMPING: Real = 4.0;
    let radius = half / 2.0;
    let corners: Vec<_> = (0..PARTS_OF_SOFT_BODY)
        .map(|corner| {
            Vector::from_fn(|axis, _| match corner >> axis & 1 {
                0 => radius - half,
                _ => half - radius,
            })
        })
        .collect();
    let balls: Vec<_> = corners
        .iter()
        .map(|corner| {
            let ball = RigidBodyBuilder::dynamic().translation(center + corner);
            world.insert(ball, ColliderBuilder::ball(radius))
        })
        .collect();
    for (end, &ball) in balls.iter().enumerate() {
        for (start, &other) in balls[..end].iter().enumerate() {
            let length = (corners[end] - corners[start]).norm();
            let spring = SpringJointBuilder::new(length, STIFFNESS, DAMPING);
            world.impulse_joints.insert(other, ball, spring, true);
        }
    }
}

/// What a step takes for a broad phase.
pub type AnyBroadPhase = dyn BroadPhase;

impl<B: BroadPhase + 'static> Steppable for B {
    fn for_step(&mut self) -> &mut AnyBroadPhase {
        self
    }
}

/// Rapier's own broad phase, as one that can be wrapped.
pub type OwnBroadPhase = DefaultBroadPhase;

/// A broad phase where a step takes it.
pub type Installed<B> = B;

/// Puts a broad phase where a step takes it.
pub fn install<B: BroadPhase>(broad_phase: B) -> Installed<B> {
    broad_phase
}

/// The tree of Rapier's own broad phase where it is wrapped.
pub fn own_tree(own: &OwnBroadPhase) -> &Bvh {
    tree_of(own, OwnBroadPhase::as_query_pipeline)
}

/// The broad phase itself, since a step of this version asks no tree.
pub fn on_own_tree<B: BroadPhase>(broad_phase: B) -> B {
    broad_phase
}

/// A broad phase that is stepped with alone, and how it is asked.
pub(super) fn alone<B: BroadPhase>(
    broad_phase: B,
    queries: AsQueryPipeline<B>,
) -> (B, AsQueryPipeline<B>) {
    (broad_phase, queries)
}

/// What only a later version asks of a broad phase.
macro_rules! when_boxes_are_handed_over {
    ($($item:item)*) => {};
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
            &self.gravity,
            &self.params,
            &mut self.islands,
            broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &mut self.impulse_joints,
            &mut self.multibody_joints,
            &mut self.ccd_solver,
            hooks,
            events,
        );
    }

    /// Runs one step of a collision pipeline, without dynamics.
    pub fn collide(&mut self, broad_phase: &mut AnyBroadPhase, events: &dyn EventHandler) {
        self.collision_pipeline.step(
            self.params.prediction_distance(),
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
        self.colliders.remove(handle, islands, bodies, true);
    }

    /// Removes a body with its colliders and joints.
    pub fn remove(&mut self, handle: RigidBodyHandle) {
        self.bodies.remove(
            handle,
            &mut self.islands,
            &mut self.colliders,
            &mut self.impulse_joints,
            &mut self.multibody_joints,
            true,
        );
    }
}
