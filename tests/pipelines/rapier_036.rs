//! What the suite needs and Rapier 0.36 has in its own way: glam's vectors, soft bodies, and one type of broad phase, which an opened
//! copy lets be custom.

use super::rapier::math;
use super::rapier::parry::query::{ShapeCastHit, ShapeCastOptions};
#[allow(unused_imports)] // In the plane, a field has one row.
use super::rapier::parry::utils::Array2;
use super::rapier::prelude::*;
use super::{AnyBroadPhase, Installed, Steppable, UnisizeBroadPhase, World};

pub(crate) type AngVector = math::AngVector;
pub(crate) type Vector = math::Vector;
pub(crate) type Pose = math::Pose;

/// A gap between boxes at which Rapier's broad phase holds a pair all the same.
pub(crate) const NEAR: Real = 0.05;

/// Whether a pair that begins may wake who sleeps.
pub(crate) const NEW_PAIRS_WAKE: bool = true;

/// What is asked for a query pipeline, if unisize is to answer.
pub(crate) type Asked = DefaultBroadPhase;

pub(crate) fn asked(unisize: &mut Installed<UnisizeBroadPhase>) -> &Asked {
    unisize.for_step()
}

/// The last coordinate is unused in two dimensions.
pub(crate) fn triple(xyz: [Real; 3]) -> Vector {
    Vector::from(std::array::from_fn(|i| xyz[i]))
}

pub(crate) fn unit(vector: Vector) -> Vector {
    vector.normalize()
}

/// The pose of what is at this place, and not turned.
pub(crate) fn pose(place: Vector) -> Pose {
    Pose::from_translation(place)
}

pub(crate) fn origin(pose: &Pose) -> Vector {
    pose.translation
}

pub(crate) fn linvel(body: &RigidBody) -> Vector {
    body.linvel()
}

/// The heights of a flat field with one row.
#[allow(dead_code)] // In space, a field has many rows.
pub(crate) fn flat_row() -> Vec<Real> {
    vec![0.0; 9]
}

/// The heights of a flat field with many rows.
#[allow(dead_code)] // In the plane, a field has one row.
pub(crate) fn flat_square() -> Array2<Real> {
    Array2::repeat(9, 9, 0.0)
}

pub(crate) fn groups(memberships: Group, filter: Group) -> InteractionGroups {
    InteractionGroups::new(memberships, filter, InteractionTestMode::And)
}

/// Whether the solver would see a contact of this pair.
pub(crate) fn touches(pair: &ContactPair) -> bool {
    pair.has_any_active_contact()
}

/// Whether a pair counts as found where two penetrate each other.
pub(crate) fn is_found(pair: &ContactPair) -> bool {
    touches(pair)
}

/// Where the particles of soft bodies are.
pub(crate) fn particles(world: &World) -> Vec<Vector> {
    let bodies = world.soft_bodies.iter();
    bodies
        .flat_map(|(_, body)| body.particle_positions())
        .collect()
}

/// What this version tells an event handler beside contacts.
macro_rules! events_of_soft_bodies {
    () => {
        fn handle_soft_body_tear_event(&self, _: &SoftBodySet, _: &SoftBodyTearEvent) {}
    };
}
pub(crate) use events_of_soft_bodies;

pub(crate) fn distance(point: Vector, place: Vector) -> Real {
    (point - place).length()
}

pub(crate) fn project_point(
    scene: &QueryPipeline<'_>,
    point: Vector,
    solid: bool,
) -> Option<(ColliderHandle, PointProjection)> {
    scene.project_point(point, Real::MAX, solid)
}

pub(crate) fn project_feature(
    scene: &QueryPipeline<'_>,
    point: Vector,
) -> Option<(ColliderHandle, PointProjection, FeatureId)> {
    scene.project_point_and_get_feature(point, Real::MAX)
}

pub(crate) fn cast_shape(
    scene: &QueryPipeline<'_>,
    from: &Pose,
    velocity: Vector,
    shape: &dyn Shape,
    options: ShapeCastOptions,
) -> Option<(ColliderHandle, ShapeCastHit)> {
    scene.cast_shape(from, velocity, shape, options)
}

/// One step of a collision pipeline, without dynamics.
pub(crate) fn collide(
    world: &mut World,
    broad_phase: &mut AnyBroadPhase,
    hooks: &dyn PhysicsHooks,
    events: &dyn EventHandler,
) {
    CollisionPipeline::new().step(
        world.params.prediction_distance(),
        &mut world.islands,
        broad_phase,
        &mut world.narrow_phase,
        &mut world.bodies,
        &mut world.colliders,
        hooks,
        events,
    );
}

pub(crate) fn remove_collider(world: &mut World, collider: ColliderHandle) {
    world.colliders.remove(
        collider,
        &mut world.islands,
        &mut world.bodies,
        &mut world.soft_bodies,
        true,
    );
}

/// Removes a body and leaves its colliders.
pub(crate) fn remove_body_alone(world: &mut World, body: RigidBodyHandle) {
    world.bodies.remove(
        body,
        &mut world.islands,
        &mut world.colliders,
        &mut world.impulse_joints,
        &mut world.multibody_joints,
        &mut world.soft_bodies,
        false,
    );
}
