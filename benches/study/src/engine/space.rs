//! Vectors, spelled alike for every flavour of Rapier, and places in `f64`, which errors are measured in.

use super::scenes::rapier::{math::DIM, parry::bounding_volume::BoundingVolume, prelude::*};
use super::scenes::{self, Vector, World};
use std::borrow::Borrow;

/// The axis along which gravity acts, downward.
pub(super) const UP: usize = 1;

/// What gravity adds to a velocity in a second.
pub(super) const GRAVITY: f64 = 9.81;

/// A place or a difference of two.
pub(super) type Place = [f64; DIM];

/// The place with these coordinates.
pub(super) fn place(coordinate: impl FnMut(usize) -> f64) -> Place {
    std::array::from_fn(coordinate)
}

/// The place at this distance along one axis.
pub(super) fn along(axis: usize, distance: f64) -> Place {
    place(|other| if other == axis { distance } else { 0.0 })
}

/// How far two places are from each other.
pub(super) fn distance(a: Place, b: Place) -> f64 {
    let squares = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b));
    squares.sum::<f64>().sqrt()
}

/// Rapier's vector.
pub(super) fn vector(place: Place) -> Vector {
    scenes::vector(|axis| place[axis] as Real)
}

/// The components of a vector, which one version of Rapier returns by reference, and another by value.
pub(super) fn components(vector: impl Borrow<Vector>) -> Place {
    let vector = vector.borrow();
    place(|axis| f64::from(vector[axis]))
}

/// Where a body is.
pub(super) fn place_of(body: &RigidBody) -> Place {
    components(body.translation())
}

/// The median of the largest extents of all colliders that can move.
pub(super) fn typical_size(world: &World) -> Real {
    let can_move = |collider: &&Collider| {
        let body = collider.parent().map(|parent| &world.bodies[parent]);
        body.is_some_and(|body| !body.is_fixed())
    };
    let colliders = world.colliders.iter().map(|(_, collider)| collider);
    let size = |collider: &Collider| {
        let aabb = collider.shape().compute_local_aabb();
        let extents = components(aabb.extents());
        extents.into_iter().fold(0.0, f64::max) as Real
    };
    let mut sizes: Vec<_> = colliders.filter(can_move).map(size).collect();
    sizes.sort_by(Real::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(1.0)
}

/// A collider with its handle.
pub(super) type Known<'a> = (ColliderHandle, &'a Collider);

/// Every two colliders that the narrow phase would look at and whose boxes, loosened by this much, overlap: the later one first.
/// Each box is compared with each. **O(n²)**.
pub(super) fn near_pairs(world: &World, slack: Real) -> Vec<[Known<'_>; 2]> {
    let enabled = world.colliders.iter_enabled();
    let boxed: Vec<_> = enabled
        .map(|known| (known.1.compute_aabb().loosened(slack), known))
        .collect();
    let mut pairs = Vec::new();
    for (index, (aabb, a)) in boxed.iter().enumerate() {
        let others = boxed[..index].iter();
        let near = others.filter(|(other, _)| aabb.intersects(other));
        let near = near.filter(|(_, b)| world.may_touch(a.1, b.1));
        pairs.extend(near.map(|(_, b)| [*a, *b]));
    }
    pairs
}

/// How far apart the two ends are that a joint of these bodies holds together.
pub(super) fn gap(
    bodies: &RigidBodySet,
    joined: [RigidBodyHandle; 2],
    joint: &GenericJoint,
) -> f64 {
    let [first, second]: [&RigidBody; 2] = joined.map(|body| &bodies[body]);
    let first = first.position() * joint.local_anchor1();
    let second = second.position() * joint.local_anchor2();
    distance(components(second - first), [0.0; DIM])
}

/// The pose and the velocities of a body as text: different numbers are different texts.
pub(super) fn motion(body: &RigidBody) -> String {
    let motion = (body.position(), body.linvel(), body.angvel());
    format!("{motion:?}")
}

/// Whether no number of a body's [motion] is infinite or NaN.
pub(super) fn is_finite(motion: &str) -> bool {
    !motion.contains("NaN") && !motion.contains("inf")
}
