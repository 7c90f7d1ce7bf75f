//! What the suite needs and Rapier 0.27 has in its own way: nalgebra's vectors, and a trait for broad phases.

use super::rapier::math;
use super::rapier::parry::query::{ShapeCastHit, ShapeCastOptions};
use super::rapier::prelude::*;
use super::{AnyBroadPhase, Installed, PairFilter, UnisizeBroadPhase, World};

pub(crate) type AngVector = math::AngVector<Real>;
pub(crate) type Vector = math::Vector<Real>;
pub(crate) type Pose = Isometry<Real>;

/// The level at which the pairs are those of Rapier's own broad phase.
pub(crate) const LEVEL_OF_OWN: PairFilter = PairFilter::Off;

/// Whether unisize sees what has changed of a collider. If not, it looks at all that were changed, and may find contacts sooner than
/// Rapier's own once these reach farther.
pub(crate) const ARE_CHANGES_SEEN: bool = false;

/// A gap between boxes at which Rapier's broad phase holds a pair all the same.
pub(crate) const NEAR: Real = 0.01;

/// What is asked for a query pipeline, if unisize is to answer.
pub(crate) type Asked = UnisizeBroadPhase;

pub(crate) fn asked(unisize: &mut Installed<UnisizeBroadPhase>) -> &Asked {
    unisize
}

/// The last coordinate is unused in two dimensions.
pub(crate) fn triple(xyz: [Real; 3]) -> Vector {
    Vector::from_fn(|i, _| xyz[i])
}

/// The indices of a voxel.
pub(crate) fn voxel(xyz: [Real; 3]) -> Point<i32> {
    triple(xyz).map(|index| index as i32).into()
}

pub(crate) fn unit(vector: Vector) -> UnitVector<Real> {
    UnitVector::new_normalize(vector)
}

/// The pose of what is at this place, and not turned.
pub(crate) fn pose(place: Vector) -> Pose {
    Pose::from(place)
}

pub(crate) fn origin(pose: &Pose) -> Vector {
    pose.translation.vector
}

pub(crate) fn linvel(body: &RigidBody) -> Vector {
    *body.linvel()
}

pub(crate) fn groups(memberships: Group, filter: Group) -> InteractionGroups {
    InteractionGroups::new(memberships, filter)
}

/// Has every step look at every contact, which this version does.
pub(crate) fn look_at_contacts_anew(_: &mut IntegrationParameters) {}

/// Sets the skin and says that the collider has moved, so that Rapier's own broad phase looks at it.
pub(crate) fn set_contact_skin(collider: &mut Collider, skin: Real) {
    collider.set_contact_skin(skin);
    let place = collider
        .position_wrt_parent()
        .map(|pose| pose.translation.vector);
    collider.set_translation_wrt_parent(place.unwrap_or_default());
}

/// Whether the solver would see a contact of this pair.
pub(crate) fn touches(pair: &ContactPair) -> bool {
    pair.has_any_active_contact
}

/// What only a later version tells an event handler.
macro_rules! events_of_soft_bodies {
    () => {};
}
pub(crate) use events_of_soft_bodies;

pub(crate) fn distance(point: Point<Real>, place: Vector) -> Real {
    (point.coords - place).norm()
}

pub(crate) fn project_point(
    scene: &QueryPipeline<'_>,
    point: Vector,
    solid: bool,
) -> Option<(ColliderHandle, PointProjection)> {
    scene.project_point(&point.into(), Real::MAX, solid)
}

pub(crate) fn project_feature(
    scene: &QueryPipeline<'_>,
    point: Vector,
) -> Option<(ColliderHandle, PointProjection, FeatureId)> {
    scene.project_point_and_get_feature(&point.into())
}

pub(crate) fn cast_shape(
    scene: &QueryPipeline<'_>,
    from: &Pose,
    velocity: Vector,
    shape: &dyn Shape,
    options: ShapeCastOptions,
) -> Option<(ColliderHandle, ShapeCastHit)> {
    scene.cast_shape(from, &velocity, shape, options)
}

/// One step of a collision pipeline, without dynamics.
pub(crate) fn collide(
    world: &mut World,
    broad_phase: &mut AnyBroadPhase,
    events: &dyn EventHandler,
) {
    CollisionPipeline::new().step(
        world.params.prediction_distance(),
        broad_phase,
        &mut world.narrow_phase,
        &mut world.bodies,
        &mut world.colliders,
        &(),
        events,
    );
}

pub(crate) fn remove_collider(world: &mut World, collider: ColliderHandle) {
    world
        .colliders
        .remove(collider, &mut world.islands, &mut world.bodies, true);
}
