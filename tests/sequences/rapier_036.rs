//! What the suite needs of Rapier 0.36 in particular.

use super::UnisizeBroadPhase;
use super::rapier::parry::query;
use super::rapier::parry::shape::HalfSpace;
use super::rapier::prelude::*;
use super::suite::World;
use crate::ops::Triple;

pub(super) use super::rapier::math::{Pose, Vector};
pub(super) type Point = Vector;

#[cfg(test)]
#[path = "../common/stretched_036.rs"]
mod stretching;
#[cfg(test)]
pub(super) use stretching::{stretched, stretched_half_space};

/// Whether a collider of other groups, or of another body, gets a new box.
pub(super) const REINSERTS: bool = true;

/// In how many runs pairs that begin take turns.
pub(super) const RUNS: usize = 1;

pub(super) fn vector(triple: Triple) -> Vector {
    Vector::from(std::array::from_fn(|i| Real::from(triple[i])))
}

/// A point with these coordinates.
pub(super) fn point(triple: Triple) -> Point {
    vector(triple)
}

pub(super) fn translation(triple: Triple) -> Pose {
    Pose::from_translation(vector(triple))
}

/// The pose moved along the axes of the world.
pub(super) fn moved(mut pose: Pose, by: Triple) -> Pose {
    pose.translation += vector(by);
    pose
}

pub(super) fn coordinates(collider: &Collider) -> [Real; DIM] {
    collider.translation().into()
}

/// The origin of a pose.
pub(super) fn origin(pose: &Pose) -> Vector {
    pose.translation
}

/// The vector from the origin to a point.
pub(super) fn arrow(point: Vector) -> Vector {
    point
}

pub(super) fn normal(half_space: &HalfSpace) -> Vector {
    half_space.normal
}

/// The box of a collider that the engine hands over once it has moved.
pub(super) fn handed_over_box(
    collider: &Collider,
    params: &IntegrationParameters,
    bodies: &RigidBodySet,
) -> Option<Aabb> {
    Some(collider.compute_broad_phase_aabb(params, bodies))
}

/// Hands boxes over, few of them one by one. Returns whether it did.
pub(super) fn hand_over(
    broad_phase: &mut UnisizeBroadPhase,
    params: &IntegrationParameters,
    boxes: &[(ColliderHandle, Aabb)],
) -> bool {
    match boxes {
        [] => return false,
        [_] | [_, _] => boxes
            .iter()
            .for_each(|&(handle, aabb)| broad_phase.set_aabb(params, handle, aabb)),
        _ => broad_phase.set_aabbs(params, boxes),
    }
    true
}

/// How far apart two colliders are, where there is an answer.
pub(super) fn distance(a: &Collider, b: &Collider) -> Option<Real> {
    let distance = query::distance(a.position(), a.shape(), b.position(), b.shape());
    Some(distance.ok()?.distance)
}

/// The norm squared of the rotation of a pose.
pub(super) fn norm_squared(pose: &Pose) -> Real {
    pose.rotation.length_squared()
}

/// Whether the shapes of two colliders intersect.
#[cfg(test)]
pub(super) fn intersect(a: &Collider, b: &Collider) -> bool {
    let test = query::intersection_test(a.position(), a.shape(), b.position(), b.shape());
    test.is_ok_and(|found| found.intersecting)
}

/// Whether two colliders have a contact within this distance, where there is an answer.
#[cfg(test)]
pub(super) fn are_in_contact(a: &Collider, b: &Collider, distance: Real) -> Option<bool> {
    let contact = query::contact(a.position(), a.shape(), b.position(), b.shape(), distance);
    Some(contact.ok()?.is_some())
}

pub(super) fn half_space(normal: Triple) -> SharedShape {
    SharedShape::halfspace(vector(normal).try_normalize().unwrap_or(Vector::Y))
}

pub(super) fn groups(memberships: Group, filter: Group) -> InteractionGroups {
    let mode = match filter == Group::GROUP_2 {
        true => InteractionTestMode::Or,
        false => InteractionTestMode::And,
    };
    InteractionGroups::new(memberships, filter, mode)
}

pub(super) fn remove_collider(world: &mut World, handle: ColliderHandle) {
    let (islands, bodies) = (&mut world.islands, &mut world.bodies);
    let colliders = &mut world.colliders;
    colliders.remove(handle, islands, bodies, &mut SoftBodySet::new(), false);
}

pub(super) fn remove_body(world: &mut World, body: RigidBodyHandle, with_colliders: bool) {
    world.bodies.remove(
        body,
        &mut world.islands,
        &mut world.colliders,
        &mut world.joints,
        &mut world.multibody_joints,
        &mut SoftBodySet::new(),
        with_colliders,
    );
}
