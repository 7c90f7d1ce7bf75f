//! What the suite needs and Rapier 0.36 has in its own way: vectors as points, and one type of broad phase, which can be custom in a
//! patched copy.

use super::rapier::parry::query::{ShapeCastHit, ShapeCastOptions};
use super::rapier::prelude::*;
use super::scenes::{Pose, Vector, vector};
use super::{Installed, PairFilter, Steppable, UnisizeBroadPhase};

#[path = "../../../../tests/common/stretched_036.rs"]
mod stretching;
pub(crate) use stretching::{stretched, stretched_half_space};

/// The level at which the pairs are those of Rapier's own broad phase.
pub(crate) const LEVEL_OF_OWN: PairFilter = PairFilter::Groups;

/// Whether unisize sees which property of a collider has changed. If not, it reads every changed collider, and may find contacts
/// sooner than Rapier's own broad phase once these reach farther.
pub(crate) const ARE_CHANGES_SEEN: bool = true;

/// Whether contacts are those of the poses after a step. If not, they are those before it.
pub(crate) const LOOKS_AFTER_MOVES: bool = false;

/// Whether a program may put back its sets and no broad phase. If not, it starts with new broad and narrow phases.
pub(crate) const CAN_SETS_BE_PUT_BACK: bool = true;

/// A gap between boxes at which Rapier's broad phase still holds a pair.
pub(crate) const NEAR: Real = 0.05;

/// The type that makes a query pipeline on unisize.
pub(crate) type Asked = DefaultBroadPhase;

pub(crate) fn asked(unisize: &mut Installed<UnisizeBroadPhase>) -> &Asked {
    unisize.for_step()
}

/// The indices of a voxel.
pub(crate) fn voxel(xyz: [Real; 3]) -> IVector {
    vect_to_ivect(vector(|axis| xyz[axis]))
}

pub(crate) fn unit(vector: Vector) -> Vector {
    vector.normalize()
}

pub(crate) fn origin(pose: &Pose) -> Vector {
    pose.translation
}

/// Has every step look at every contact, though the two have hardly moved.
pub(crate) fn look_at_contacts_anew(params: &mut IntegrationParameters) {
    params.normalized_contact_recycle_distance = 0.0;
}

/// The least distance of the points of two colliders' contact.
pub(crate) fn least_distance(pair: &ContactPair) -> Real {
    let points = pair
        .manifolds()
        .iter()
        .flat_map(|manifold| &manifold.points);
    points.fold(Real::MAX, |least, point| least.min(point.dist))
}

/// Sets the skin.
pub(crate) fn set_contact_skin(collider: &mut Collider, skin: Real) {
    collider.set_contact_skin(skin);
}

/// The events that this version has beside contacts.
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
