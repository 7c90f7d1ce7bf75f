//! The filter key of a collider: what decides which others it may meet, as the narrow phase decides it.

use super::rapier::dynamics::{RigidBody, RigidBodyType};
use super::rapier::geometry::{ActiveCollisionTypes, Collider, InteractionGroups};
use super::version;
use crate::pair_filter::PairFilter;
use crate::pair_tracker::FilterKey;

/// The properties of a collider and its body that decide whether it may meet another one, in 16 bytes: keys of candidates are read
/// in no order. Those that nobody looks at are the same for all.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(crate) struct ColliderKey {
    /// The index of the body; [`NOBODY`] if there is none.
    body: u32,
    /// Of the groups.
    memberships: u32,
    filter: u32,
    /// From the lowest bit: whether it meets bodies of each of the [`TYPES`], of which of them its own body is, that body's type
    /// exactly, and the flags.
    bits: u32,
}

/// Stands for no body.
const NOBODY: u32 = u32::MAX;

/// The types of bodies that are told apart by whom they meet. All others count as the first.
const TYPES: [RigidBodyType; 4] = [
    RigidBodyType::Dynamic,
    RigidBodyType::Fixed,
    RigidBodyType::KinematicPositionBased,
    RigidBodyType::KinematicVelocityBased,
];

/// Where bits begin.
const TYPE: u32 = TYPES.len() as u32;
const EXACT_TYPE: u32 = TYPE + 2;
const FLAGS: u32 = EXACT_TYPE + 8;

/// Flags.
const IS_SENSOR: u32 = 1 << FLAGS;
/// Groups meet if either is in the filter of the other.
const IS_EITHER_ENOUGH: u32 = 2 << FLAGS;
/// Bodies and their types decide, and groups decide: the same for all keys.
const BODIES_DECIDE: u32 = 4 << FLAGS;
const GROUPS_DECIDE: u32 = 8 << FLAGS;

impl Default for ColliderKey {
    /// The key of a collider that may meet all others with this key.
    fn default() -> Self {
        Self {
            body: NOBODY,
            memberships: u32::MAX,
            filter: u32::MAX,
            bits: type_bits(RigidBodyType::Dynamic, ActiveCollisionTypes::all()),
        }
    }
}

/// What a key says of the type of the body, and of the types that it meets.
#[inline(always)]
fn type_bits(body_type: RigidBodyType, meets: ActiveCollisionTypes) -> u32 {
    let index = TYPES.iter().position(|&known| known == body_type);
    let index = index.unwrap_or(0) as u32;
    let met = (0..).zip(TYPES).fold(0, |met, (i, other)| {
        met | u32::from(meets.test(body_type, other)) << i
    });
    met | index << TYPE | (body_type as u32) << EXACT_TYPE
}

impl ColliderKey {
    /// Whether keys differ with this filter.
    pub(super) fn differ(filter: PairFilter) -> bool {
        filter != PairFilter::Off || version::REINSERTS
    }

    #[inline(always)]
    pub(super) fn new(filter: PairFilter, collider: &Collider, body: Option<&RigidBody>) -> Self {
        if !Self::differ(filter) {
            return Self::default();
        }
        let parent = collider.parent();
        let body_type = body.map_or(RigidBodyType::Fixed, RigidBody::body_type);
        let groups = match filter >= PairFilter::Groups || version::REINSERTS {
            true => collider.collision_groups(),
            false => InteractionGroups::all(),
        };
        let flag = |flag: u32, is_set: bool| if is_set { flag } else { 0 };
        Self {
            body: parent.map_or(NOBODY, |body| body.into_raw_parts().0),
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
}

impl FilterKey for ColliderKey {
    #[inline(always)]
    fn may_meet(self, other: Self) -> bool {
        let has = |flag: u32| self.bits & flag != 0;
        let is_of_one_body = (self.body == other.body) & (self.body != NOBODY);
        let meets_type = |a: Self, b: Self| a.bits >> (b.bits >> TYPE & 3) & 1 == 1;
        let types_meet = meets_type(self, other) | meets_type(other, self);
        let a = self.memberships & other.filter != 0;
        let b = other.memberships & self.filter != 0;
        let is_either_enough = self.bits & other.bits & IS_EITHER_ENOUGH != 0;
        let groups_meet = (a & b) | (is_either_enough & (a | b));
        (!is_of_one_body & types_meet | !has(BODIES_DECIDE)) & (groups_meet | !has(GROUPS_DECIDE))
    }

    #[inline(always)]
    fn may_touch(self, other: Self) -> bool {
        (self.bits | other.bits) & IS_SENSOR == 0
    }

    /// Whatever the filter, because the box without a margin shows in the pairs.
    fn renews_box(self, former: Self) -> bool {
        let bits = 0xff << EXACT_TYPE | IS_EITHER_ENOUGH;
        let decisive = |key: Self| (key.body, key.memberships, key.filter, key.bits & bits);
        version::REINSERTS && decisive(self) != decisive(former)
    }
}

#[cfg(test)]
mod tests {
    use super::super::rapier::dynamics::RigidBodyBuilder;
    use super::super::rapier::geometry::{ColliderBuilder, Group};
    use super::*;

    /// Colliders on bodies of every type, with groups and active collision types of many kinds, and their keys.
    fn all() -> Vec<(RigidBodyType, Collider, ColliderKey)> {
        let groups = [(1, 2), (2, 1), (3, 3), (0, 7), (u32::MAX, 4)];
        let groups = groups.map(|(memberships, filter)| {
            version::all_groups(
                Group::from_bits_retain(memberships),
                Group::from_bits_retain(filter),
            )
        });
        let mut all = Vec::new();
        for body_type in TYPES {
            for bits in [0, 1, 2, 0b1100, 0b10_0000, 0b1100_0000, 0xf000, 0xffff] {
                for &groups in groups.iter().flatten() {
                    let body = RigidBodyBuilder::new(body_type).build();
                    let collider = ColliderBuilder::ball(1.0)
                        .active_collision_types(ActiveCollisionTypes::from_bits_retain(bits))
                        .collision_groups(groups)
                        .build();
                    let key = ColliderKey::new(PairFilter::Groups, &collider, Some(&body));
                    all.push((body_type, collider, key));
                }
            }
        }
        all
    }

    #[test]
    fn keys_meet_as_the_narrow_phase_decides() {
        let all = all();
        let mut met = 0;
        for (first_type, first, first_key) in &all {
            for (second_type, second, second_key) in &all {
                let is_active = |collider: &Collider| {
                    let types = collider.active_collision_types();
                    types.test(*first_type, *second_type)
                };
                let groups = first.collision_groups();
                let expected = (is_active(first) || is_active(second))
                    && groups.test(second.collision_groups());
                assert_eq!(first_key.may_meet(*second_key), expected);
                met += usize::from(expected);
            }
        }
        assert!(met > 0 && met < all.len() * all.len());
    }
}
