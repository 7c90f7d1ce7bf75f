//! What the measurements need and Rapier 0.27 has in its own way.

use super::scenes::rapier::{math, prelude::*};

pub(super) type Vector = math::Vector<Real>;

/// The impulses of a pair in the last step.
///
/// Rapier 0.27 starts its sum with the impulse that it begins a step with, which is that of the last of the substeps before: with
/// four substeps, the sum at rest is of five. It is taken off again; at rest it is the same as after the step.
pub(super) fn impulse(pair: &ContactPair) -> Real {
    let points = pair.manifolds.iter().flat_map(|manifold| &manifold.points);
    points
        .map(|point| point.data.impulse - point.data.warmstart_impulse)
        .sum()
}

/// The two bodies of a joint.
pub(super) fn joined(joint: &ImpulseJoint) -> [RigidBodyHandle; 2] {
    [joint.body1, joint.body2]
}
