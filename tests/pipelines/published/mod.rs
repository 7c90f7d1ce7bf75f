//! Rapier 0.36 as it is published, whose pipelines accept no broad phase but their own: `stepped` follows its `PhysicsPipeline` and
//! compares with what its narrow phase holds, and `updates` has single updates made by hand. `tests/sequences` checks random updates
//! against a model, and `examples/opened/tests` whole worlds on an opened copy.

use std::collections::BTreeSet;

use oorandom::Rand32;

use super::rapier::prelude::*;
use super::{PairFilter, Settings, UnisizeBroadPhase};

mod stepped;
mod updates;

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
