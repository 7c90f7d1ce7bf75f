//! What the measurements need and Rapier 0.36 has in its own way.

use super::scenes::rapier::{math, prelude::*};

pub(super) type Vector = math::Vector;

/// The impulses of a pair in the last step.
pub(super) fn impulse(pair: &ContactPair) -> Real {
    pair.total_impulse_magnitude()
}

/// The two bodies of a joint.
pub(super) fn joined(joint: &ImpulseJoint) -> [RigidBodyHandle; 2] {
    [joint.body1(), joint.body2()]
}
