//! The filter key of a collider: what decides which others it may meet, as the narrow phase decides it.

use super::rapier::dynamics::{RigidBody, RigidBodyType};
use super::rapier::geometry::{ActiveCollisionTypes, Collider, InteractionGroups};
use super::version;
use crate::PairFilter;
use crate::pair_tracker::FilterKey;

/// The properties of a collider and its body that decide whether it may meet another one. Those that nobody looks at are
/// the same for all.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize)
)]
pub(super) struct ColliderKey {
    /// What is looked at; the same for all.
    filter: PairFilter,
    /// The index of the body; [`NOBODY`] if there is none.
    body: u32,
    body_type: RigidBodyType,
    collision_types: ActiveCollisionTypes,
    groups: InteractionGroups,
    is_sensor: bool,
}

/// Stands for no body.
const NOBODY: u32 = u32::MAX;

impl Default for ColliderKey {
    /// The key of a collider that may meet all others with this key.
    fn default() -> Self {
        Self {
            filter: PairFilter::Off,
            body: NOBODY,
            body_type: RigidBodyType::Dynamic,
            collision_types: ActiveCollisionTypes::all(),
            groups: InteractionGroups::all(),
            is_sensor: false,
        }
    }
}

impl ColliderKey {
    /// Whether keys differ with this filter.
    pub(super) fn differ(filter: PairFilter) -> bool {
        filter != PairFilter::Off || version::REINSERTS
    }

    #[inline(always)]
    pub(super) fn new(filter: PairFilter, collider: &Collider, body: Option<&RigidBody>) -> Self {
        let mut key = Self::default();
        if !Self::differ(filter) {
            return key;
        }
        let parent = collider.parent();
        key.filter = filter;
        key.body = parent.map_or(NOBODY, |body| body.into_raw_parts().0);
        key.body_type = body.map_or(RigidBodyType::Fixed, RigidBody::body_type);
        key.collision_types = collider.active_collision_types();
        key.is_sensor = filter >= PairFilter::Shapes && collider.is_sensor();
        if filter >= PairFilter::Groups || version::REINSERTS {
            key.groups = collider.collision_groups();
        }
        key
    }
}

impl FilterKey for ColliderKey {
    #[inline(always)]
    fn may_meet(self, other: Self) -> bool {
        let types = [self.body_type, other.body_type];
        let types_meet = |key: Self| key.collision_types.test(types[0], types[1]);
        let is_of_one_body = self.body == other.body && self.body != NOBODY;
        let bodies_meet = !is_of_one_body & (types_meet(self) | types_meet(other));
        let groups_meet = self.groups.test(other.groups);
        (bodies_meet | (self.filter == PairFilter::Off))
            & (groups_meet | (self.filter < PairFilter::Groups))
    }

    #[inline(always)]
    fn may_touch(self, other: Self) -> bool {
        !(self.is_sensor | other.is_sensor)
    }

    /// Whatever the filter, because the box without a margin shows in the pairs.
    fn renews_box(self, former: Self) -> bool {
        let decisive = |key: Self| (key.body, key.body_type, key.groups);
        version::REINSERTS && decisive(self) != decisive(former)
    }
}
