//! What the suite needs and Rapier 0.27 has in its own way: points that are no vectors, and a trait for broad phases.

use super::rapier::parry::query::{ShapeCastHit, ShapeCastOptions};
use super::rapier::prelude::*;
use super::scenes::{Pose, Vector, vector};
use super::{Installed, PairFilter, UnisizeBroadPhase};

#[path = "../../../../tests/common/stretched_027.rs"]
mod stretching;
pub(crate) use stretching::{stretched, stretched_half_space};

/// The level at which the pairs are those of Rapier's own broad phase.
pub(crate) const LEVEL_OF_OWN: PairFilter = PairFilter::Off;

/// Whether unisize sees which property of a collider has changed. If not, it reads every changed collider, and may find contacts
/// sooner than Rapier's own broad phase once these reach farther.
pub(crate) const ARE_CHANGES_SEEN: bool = false;

/// Whether contacts are those of the poses after a step. If not, they are those before it.
pub(crate) const LOOKS_AFTER_MOVES: bool = true;

/// Whether a program may put back its sets and no broad phase. If not, it starts with new broad and narrow phases.
pub(crate) const CAN_SETS_BE_PUT_BACK: bool = false;

/// A gap between boxes at which Rapier's broad phase still holds a pair.
pub(crate) const NEAR: Real = 0.01;

/// The type that makes a query pipeline on unisize.
pub(crate) type Asked = UnisizeBroadPhase;

pub(crate) fn asked(unisize: &mut Installed<UnisizeBroadPhase>) -> &Asked {
    unisize
}

/// The indices of a voxel.
pub(crate) fn voxel(xyz: [Real; 3]) -> Point<i32> {
    vector(|axis| xyz[axis]).map(|index| index as i32).into()
}

pub(crate) fn unit(vector: Vector) -> UnitVector<Real> {
    UnitVector::new_normalize(vector)
}

pub(crate) fn origin(pose: &Pose) -> Vector {
    pose.translation.vector
}

/// Has every step look at every contact, which this version does.
pub(crate) fn look_at_contacts_anew(_: &mut IntegrationParameters) {}

/// The least distance of the points of two colliders' contact.
pub(crate) fn least_distance(pair: &ContactPair) -> Real {
    let points = pair.manifolds.iter().flat_map(|manifold| &manifold.points);
    points.fold(Real::MAX, |least, point| least.min(point.dist))
}

/// Sets the skin and says that the collider has moved, so that Rapier's own broad phase looks at it.
pub(crate) fn set_contact_skin(collider: &mut Collider, skin: Real) {
    collider.set_contact_skin(skin);
    let place = collider
        .position_wrt_parent()
        .map(|pose| pose.translation.vector);
    collider.set_translation_wrt_parent(place.unwrap_or_default());
}

/// The events that only a later version has.
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
