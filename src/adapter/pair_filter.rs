//! Which pairs the narrow phase would drop anyway, so that they need not be reported.
//!
//! The conditions are those of `NarrowPhase::compute_contacts` and `compute_intersections` in Rapier 0.27;
//! newer versions of Rapier's own broad phase filter by them too.

use super::rapier::dynamics::{RigidBodyHandle, RigidBodySet, RigidBodyType};
use super::rapier::geometry::{ActiveCollisionTypes, Collider, InteractionGroups};
use crate::pair_tracker::Tag;

/// What decides whether two colliders may interact at all.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PairFilter {
    parent: Option<RigidBodyHandle>,
    body_type: RigidBodyType,
    active_types: ActiveCollisionTypes,
    groups: InteractionGroups,
}

impl PairFilter {
    pub(super) fn of(collider: &Collider, bodies: &RigidBodySet) -> Self {
        let body = collider.parent().and_then(|parent| bodies.get(parent));
        Self {
            parent: collider.parent(),
            body_type: body.map_or(RigidBodyType::Fixed, |body| body.body_type()),
            active_types: collider.active_collision_types(),
            groups: collider.collision_groups(),
        }
    }
}

impl Tag for PairFilter {
    fn allows(&self, other: &Self) -> bool {
        let types = self.active_types | other.active_types;
        (self.parent != other.parent || self.parent.is_none())
            && types.test(self.body_type, other.body_type)
            && self.groups.test(other.groups)
    }
}
