//! The suite: one source for both dimensions, which the module that includes it names as `rapier`.

use std::collections::BTreeSet;

use oorandom::Rand32;

use super::rapier::prelude::*;
use super::{PairFilter, Settings, UnisizeBroadPhase};

mod driven;
mod queries;
mod stepped;

/// Two colliders, by index and generation, the smaller index first.
type Pair = [(u32, u32); 2];

fn raw(first: ColliderHandle, second: ColliderHandle) -> Pair {
    let mut pair = [first, second].map(|handle| handle.into_raw_parts());
    pair.sort_unstable();
    pair
}

fn pairs(broad_phase: &UnisizeBroadPhase) -> BTreeSet<Pair> {
    let pairs = broad_phase.pairs();
    pairs
        .map(|pair| raw(pair.collider1, pair.collider2))
        .collect()
}

/// Whether the narrow phase would look at two colliders.
fn may_meet(pair: Pair, colliders: &ColliderSet, bodies: &RigidBodySet) -> bool {
    let pair = pair
        .map(|(index, generation)| &colliders[ColliderHandle::from_raw_parts(index, generation)]);
    let [first, second] = pair;
    let are_on_one_body = first.parent().is_some() && first.parent() == second.parent();
    let [one, other] = pair.map(|collider| match collider.parent() {
        Some(body) => bodies[body].body_type(),
        None => RigidBodyType::Fixed,
    });
    let mut types = pair
        .iter()
        .map(|collider| collider.active_collision_types());
    let groups_meet = first.collision_groups().test(second.collision_groups());
    !are_on_one_body && types.any(|types| types.test(one, other)) && groups_meet
}

/// A vector with each coordinate within this distance of 0.
fn within(random: &mut Rand32, distance: Real) -> Vector {
    Vector::from(std::array::from_fn(|_| {
        distance * Real::from(2.0 * random.rand_float() - 1.0)
    }))
}

/// One of several shapes.
fn shape(random: &mut Rand32) -> SharedShape {
    let mut length = || 0.2 + 0.6 * random.rand_float();
    let lengths: [Real; 3] = std::array::from_fn(|_| Real::from(length()));
    match random.rand_range(0..4) {
        0 => SharedShape::ball(lengths[0]),
        1 => SharedShape::new(Cuboid::new(Vector::from(std::array::from_fn(|k| {
            lengths[k]
        })))),
        2 => SharedShape::capsule_x(lengths[0], lengths[1]),
        _ => SharedShape::compound(vec![
            (Pose::IDENTITY, SharedShape::ball(lengths[0])),
            (
                Pose::from_translation(Vector::X * lengths[1]),
                SharedShape::ball(lengths[2]),
            ),
        ]),
    }
}

/// A collider of which everything that filters look at is random.
fn collider(random: &mut Rand32) -> ColliderBuilder {
    let groups = [Group::ALL, Group::ALL, Group::GROUP_1, Group::GROUP_2];
    let mut group = || groups[random.rand_range(0..4) as usize];
    let groups = InteractionGroups::new(group(), group(), InteractionTestMode::And);
    let types = match random.rand_range(0..5) {
        0 => ActiveCollisionTypes::all(),
        1 => ActiveCollisionTypes::empty(),
        _ => ActiveCollisionTypes::default(),
    };
    ColliderBuilder::new(shape(random))
        .sensor(random.rand_range(0..4) == 0)
        .collision_groups(groups)
        .active_collision_types(types)
}

fn body(random: &mut Rand32) -> RigidBodyBuilder {
    match random.rand_range(0..6) {
        0 => RigidBodyBuilder::fixed(),
        1 => RigidBodyBuilder::kinematic_velocity_based().linvel(within(random, 2.0)),
        _ => RigidBodyBuilder::dynamic(),
    }
}
