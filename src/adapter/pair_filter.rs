//! Which pairs the narrow phase would drop unseen, so that they need not be reported.
//!
//! The conditions are those of `NarrowPhase::compute_contacts` and `compute_intersections` in Rapier 0.27.
//! They are applied only where neither body is dynamic (the stones of a wall, the parts of a building):
//! through the pairs that it holds, even ones without contacts, the narrow phase also finds the sleeping
//! bodies to wake when one of their neighbours changes.

use super::rapier::dynamics::{RigidBody, RigidBodyHandle, RigidBodyType};
use super::rapier::geometry::{ActiveCollisionTypes, Collider, InteractionGroups};
use crate::pair_tracker::Tag;

/// What decides whether two colliders may interact at all: nothing for a collider all of whose pairs are of
/// interest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PairFilter(Option<Traits>);

/// What the narrow phase looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Traits {
    parent: Option<RigidBodyHandle>,
    body_type: RigidBodyType,
    active_types: ActiveCollisionTypes,
    groups: InteractionGroups,
}

impl PairFilter {
    /// Every pair is of interest.
    pub(super) const OPEN: Self = Self(None);

    /// The filter of a collider and the body that it is attached to.
    #[inline]
    pub(super) fn of(collider: &Collider, body: Option<&RigidBody>) -> Self {
        let body_type = body.map_or(RigidBodyType::Fixed, RigidBody::body_type);
        if body_type == RigidBodyType::Dynamic {
            return Self::OPEN;
        }
        Self(Some(Traits {
            parent: collider.parent(),
            body_type,
            active_types: collider.active_collision_types(),
            groups: collider.collision_groups(),
        }))
    }
}

impl Tag for PairFilter {
    #[inline]
    fn is_open(&self) -> bool {
        self.0.is_none()
    }

    #[inline]
    fn allows(&self, other: &Self) -> bool {
        let (Some(a), Some(b)) = (self.0, other.0) else {
            return true;
        };
        (a.parent != b.parent || a.parent.is_none())
            && (a.active_types | b.active_types).test(a.body_type, b.body_type)
            && a.groups.test(b.groups)
    }
}
