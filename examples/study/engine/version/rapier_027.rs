//! What Rapier 0.27 spells in its own way: nalgebra's vectors, and a trait for broad phases.

use super::grid::HashGrid;
use super::scenes::rapier::{math, prelude::*};
use crate::finder::Cell;

pub(super) use super::scenes::rapier::geometry::BroadPhase;

pub(super) type Vector = math::Vector<Real>;
pub(super) type Point = math::Point<Real>;
pub(super) type AngVector = math::AngVector<Real>;

/// The contacts of a pair.
pub(super) fn manifolds(pair: &ContactPair) -> &[ContactManifold] {
    &pair.manifolds
}

/// A step asks no tree.
pub(super) fn on_rapiers_tree<B: BroadPhase>(broad_phase: B) -> B {
    broad_phase
}

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

/// A broad phase that is a hash grid of centres.
pub(super) fn hash_grid(cell: Cell) -> Option<HashGrid> {
    Some(HashGrid::new(cell))
}

/// What only a later version asks of a broad phase.
macro_rules! when_boxes_are_handed_over {
    ($($item:item)*) => {};
}
pub(super) use when_boxes_are_handed_over;
