//! What the suite needs of Rapier 0.27 in particular.

use super::UnisizeBroadPhase;
use super::rapier::math;
use super::rapier::na::Normed;
use super::rapier::parry::query;
use super::rapier::parry::shape::HalfSpace;
use super::rapier::prelude::*;
use super::suite::World;
use super::suite::checked::CheckedBroadPhase;
use crate::ops::Triple;

#[cfg(test)]
#[path = "pipelines.rs"]
mod pipelines;

pub(super) type Pose = Isometry<Real>;
pub(super) type Point = math::Point<Real>;
pub(super) type Vector = math::Vector<Real>;

#[cfg(test)]
#[path = "../common/stretched_027.rs"]
mod stretching;
#[cfg(test)]
pub(super) use stretching::{stretched, stretched_half_space};

/// Whether a collider of other groups, or of another body, gets a new box.
pub(super) const REINSERTS: bool = false;

/// In how many runs pairs that begin take turns.
pub(super) const RUNS: usize = 2;

pub(super) fn vector(triple: Triple) -> Vector {
    Vector::from_fn(|i, _| Real::from(triple[i]))
}

/// A point with these coordinates.
pub(super) fn point(triple: Triple) -> Point {
    vector(triple).into()
}

pub(super) fn translation(triple: Triple) -> Pose {
    Isometry::from_parts(vector(triple).into(), Rotation::identity())
}

/// The pose moved along the axes of the world.
pub(super) fn moved(mut pose: Pose, by: Triple) -> Pose {
    pose.translation.vector += vector(by);
    pose
}

pub(super) fn coordinates(collider: &Collider) -> [Real; DIM] {
    (*collider.translation()).into()
}

/// The origin of a pose.
pub(super) fn origin(pose: &Pose) -> Vector {
    pose.translation.vector
}

/// The vector from the origin to a point.
pub(super) fn arrow(point: Point) -> Vector {
    point.coords
}

pub(super) fn normal(half_space: &HalfSpace) -> Vector {
    *half_space.normal
}

/// The box of a collider that this version hands over: none.
pub(super) fn handed_over_box(
    _: &Collider,
    _: &IntegrationParameters,
    _: &RigidBodySet,
) -> Option<Aabb> {
    None
}

/// Hands boxes over, which this version does not do. Returns whether it did.
pub(super) fn hand_over(
    _: &mut UnisizeBroadPhase,
    _: &IntegrationParameters,
    _: &[(ColliderHandle, Aabb)],
) -> bool {
    false
}

/// How far apart two colliders are, where there is an answer.
pub(super) fn distance(a: &Collider, b: &Collider) -> Option<Real> {
    query::distance(a.position(), a.shape(), b.position(), b.shape()).ok()
}

/// The norm squared of the rotation of a pose.
pub(super) fn norm_squared(pose: &Pose) -> Real {
    Normed::norm_squared(pose.rotation.as_ref())
}

/// Whether the shapes of two colliders intersect.
#[cfg(test)]
pub(super) fn intersect(a: &Collider, b: &Collider) -> bool {
    query::intersection_test(a.position(), a.shape(), b.position(), b.shape()) == Ok(true)
}

/// Whether two colliders have a contact within this distance, where there is an answer.
#[cfg(test)]
pub(super) fn are_in_contact(a: &Collider, b: &Collider, distance: Real) -> Option<bool> {
    let contact = query::contact(a.position(), a.shape(), b.position(), b.shape(), distance);
    Some(contact.ok()?.is_some())
}

pub(super) fn half_space(normal: Triple) -> SharedShape {
    let normal = UnitVector::try_new(vector(normal), 0.0);
    SharedShape::halfspace(normal.unwrap_or(Vector::y_axis()))
}

pub(super) fn groups(memberships: Group, filter: Group) -> InteractionGroups {
    InteractionGroups::new(memberships, filter)
}

/// Wakes nothing: waking a body whose type has just changed would corrupt the engine's list of active bodies.
pub(super) fn remove_collider(world: &mut World, handle: ColliderHandle) {
    let (islands, bodies) = (&mut world.islands, &mut world.bodies);
    let colliders = &mut world.colliders;
    colliders.remove(handle, islands, bodies, false);
}

pub(super) fn remove_body(world: &mut World, body: RigidBodyHandle, with_colliders: bool) {
    world.bodies.remove(
        body,
        &mut world.islands,
        &mut world.colliders,
        &mut world.joints,
        &mut world.multibody_joints,
        with_colliders,
    );
}

impl BroadPhase for CheckedBroadPhase {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.check_update(params, colliders, bodies, [modified, removed], events);
    }
}
