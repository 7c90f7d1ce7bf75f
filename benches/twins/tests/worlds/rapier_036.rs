//! What the suite needs and Rapier 0.36 has in its own way: glam's vectors, and one type of broad phase, which an opened
//! copy lets be custom.

use super::rapier::math;
use super::rapier::parry::query::{ShapeCastHit, ShapeCastOptions};
use super::rapier::prelude::*;
use super::{AnyBroadPhase, Installed, PairFilter, Steppable, UnisizeBroadPhase, World};

pub(crate) type AngVector = math::AngVector;
pub(crate) type Vector = math::Vector;
pub(crate) type Pose = math::Pose;

/// The level at which the pairs are those of Rapier's own broad phase.
pub(crate) const LEVEL_OF_OWN: PairFilter = PairFilter::Groups;

/// Whether unisize sees what has changed of a collider. If not, it looks at all that were changed, and may find contacts sooner than
/// Rapier's own once these reach farther.
pub(crate) const ARE_CHANGES_SEEN: bool = true;

/// A gap between boxes at which Rapier's broad phase holds a pair all the same.
pub(crate) const NEAR: Real = 0.05;

/// What is asked for a query pipeline, if unisize is to answer.
pub(crate) type Asked = DefaultBroadPhase;

pub(crate) fn asked(unisize: &mut Installed<UnisizeBroadPhase>) -> &Asked {
    unisize.for_step()
}

/// The last coordinate is unused in two dimensions.
pub(crate) fn triple(xyz: [Real; 3]) -> Vector {
    Vector::from(std::array::from_fn(|i| xyz[i]))
}

/// The indices of a voxel.
pub(crate) fn voxel(xyz: [Real; 3]) -> IVector {
    vect_to_ivect(triple(xyz))
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

pub(crate) fn groups(memberships: Group, filter: Group) -> InteractionGroups {
    InteractionGroups::new(memberships, filter, InteractionTestMode::And)
}

/// Has every step look at every contact, though the two have hardly moved.
pub(crate) fn look_at_contacts_anew(params: &mut IntegrationParameters) {
    params.normalized_contact_recycle_distance = 0.0;
}

/// Sets the skin.
pub(crate) fn set_contact_skin(collider: &mut Collider, skin: Real) {
    collider.set_contact_skin(skin);
}

/// Whether the solver would see a contact of this pair.
pub(crate) fn touches(pair: &ContactPair) -> bool {
    pair.has_any_active_contact()
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
    events: &dyn EventHandler,
) {
    CollisionPipeline::new().step(
        world.params.prediction_distance(),
        &mut world.islands,
        broad_phase,
        &mut world.narrow_phase,
        &mut world.bodies,
        &mut world.colliders,
        &(),
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
