//! The filter key of a collider, which decides like the narrow phase which other colliders it may meet.

use super::rapier::dynamics::{RigidBody, RigidBodyType};
use super::rapier::geometry::{ActiveCollisionTypes, Collider, InteractionGroups};
use super::version;
use crate::pair_filter::PairFilter;
use crate::pair_tracker::FilterKey;

/// The properties of a collider and its body that decide whether it may meet another collider. They are packed into 16 bytes, because the keys
/// of candidates are read at random. Properties that neither the filter nor [`renews_box`](FilterKey::renews_box) reads are the same in all
/// keys. All may meet a collider with the default key.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) struct ColliderKey {
    /// The index of the body, or [`NO_BODY`].
    body: u32,
    /// The memberships of the collision groups.
    memberships: u32,
    /// The filter of the collision groups.
    filter: u32,
    /// From the lowest bit: whether the collider meets bodies of each of the [`TYPES`], the index of its own body's type in them, Rapier's
    /// number of that type, and the flags.
    bits: u32,
}

/// The index of a missing body.
const NO_BODY: u32 = u32::MAX;

/// The types of bodies that active collision types distinguish. Other types count as the first.
const TYPES: [RigidBodyType; 4] = [
    RigidBodyType::Dynamic,
    RigidBodyType::Fixed,
    RigidBodyType::KinematicPositionBased,
    RigidBodyType::KinematicVelocityBased,
];

/// The lowest bit of each part.
const TYPE: u32 = TYPES.len() as u32;
const EXACT_TYPE: u32 = TYPE + 2;
const FLAGS: u32 = EXACT_TYPE + 8;

const IS_SENSOR: u32 = 1 << FLAGS;
/// It is enough that one of two groups is in the filter of the other.
const IS_EITHER_ENOUGH: u32 = 2 << FLAGS;
/// Whether bodies and their types decide, and whether groups decide: the same in all keys.
const BODIES_DECIDE: u32 = 4 << FLAGS;
const GROUPS_DECIDE: u32 = 8 << FLAGS;

/// The bits for the type of the body, and for the types that it meets.
#[inline(always)]
fn type_bits(body_type: RigidBodyType, meets: ActiveCollisionTypes) -> u32 {
    let index = TYPES.iter().position(|&known| known == body_type);
    let index = index.unwrap_or(0) as u32;
    let met = (0..).zip(TYPES).fold(0, |met, (i, other)| {
        met | u32::from(meets.test(body_type, other)) << i
    });
    met | index << TYPE | (body_type as u32) << EXACT_TYPE
}

/// The index of the body of a collider, and the groups that count with this filter.
#[inline(always)]
fn body_and_groups(filter: PairFilter, collider: &Collider) -> (u32, InteractionGroups) {
    let body = collider.parent();
    let groups = match filter >= PairFilter::Groups || version::REINSERTS {
        true => collider.collision_groups(),
        false => InteractionGroups::all(),
    };
    (body.map_or(NO_BODY, |body| body.into_raw_parts().0), groups)
}

impl ColliderKey {
    #[inline(always)]
    pub(super) fn new(filter: PairFilter, collider: &Collider, body: Option<&RigidBody>) -> Self {
        // Neither this filter nor this version of Rapier needs keys.
        if filter == PairFilter::Off && !version::REINSERTS {
            return Self::default();
        }
        let (body_index, groups) = body_and_groups(filter, collider);
        let body_type = body.map_or(RigidBodyType::Fixed, RigidBody::body_type);
        let flag = |flag: u32, is_set: bool| if is_set { flag } else { 0 };
        Self {
            body: body_index,
            memberships: groups.memberships.bits(),
            filter: groups.filter.bits(),
            bits: type_bits(body_type, collider.active_collision_types())
                | flag(
                    IS_SENSOR,
                    filter >= PairFilter::Shapes && collider.is_sensor(),
                )
                | flag(IS_EITHER_ENOUGH, version::is_either_enough(&groups))
                | flag(BODIES_DECIDE, filter >= PairFilter::Bodies)
                | flag(GROUPS_DECIDE, filter >= PairFilter::Groups),
        }
    }

    /// False if the key belongs to another body or to other groups.
    #[inline(always)]
    pub(super) fn may_be_of(&self, filter: PairFilter, collider: &Collider) -> bool {
        let (body, groups) = body_and_groups(filter, collider);
        let is_either_enough = self.bits & IS_EITHER_ENOUGH != 0;
        (self.body, self.memberships, self.filter)
            == (body, groups.memberships.bits(), groups.filter.bits())
            && is_either_enough == version::is_either_enough(&groups)
    }
}

impl FilterKey for ColliderKey {
    #[inline(always)]
    fn may_meet(self, other: Self) -> bool {
        let has = |flag: u32| self.bits & flag != 0;
        let is_of_one_body = (self.body == other.body) & (self.body != NO_BODY);
        let meets_type = |a: Self, b: Self| a.bits >> (b.bits >> TYPE & 3) & 1 == 1;
        let types_meet = meets_type(self, other) | meets_type(other, self);
        let a = self.memberships & other.filter != 0;
        let b = other.memberships & self.filter != 0;
        let is_either_enough = self.bits & other.bits & IS_EITHER_ENOUGH != 0;
        let groups_meet = (a & b) | (is_either_enough & (a | b));
        (!is_of_one_body & types_meet | !has(BODIES_DECIDE)) & (groups_meet | !has(GROUPS_DECIDE))
    }

    /// The body, unless it is fixed: then its colliders hardly move, so few are searched for.
    fn clique(self) -> Option<u32> {
        let body_type = TYPES[(self.bits >> TYPE & 3) as usize];
        let is_one = self.body != NO_BODY && body_type != RigidBodyType::Fixed;
        (is_one && self.bits & BODIES_DECIDE != 0).then_some(self.body)
    }

    #[inline(always)]
    fn may_touch(self, other: Self) -> bool {
        (self.bits | other.bits) & IS_SENSOR == 0
    }

    /// This holds for every filter, because the renewed box has no margin, which affects the pairs.
    fn renews_box(self, former: Self) -> bool {
        let bits = 0xff << EXACT_TYPE | IS_EITHER_ENOUGH;
        let decisive = |key: Self| (key.body, key.memberships, key.filter, key.bits & bits);
        version::REINSERTS && decisive(self) != decisive(former)
    }
}
