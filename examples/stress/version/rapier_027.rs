//! What Rapier 0.27 spells in its own way: nalgebra's vectors, and a trait for broad phases.

use super::dimension::Clocked;
use super::scenes::rapier::{geometry::BroadPhase, math, prelude::*};

pub(super) type Vector = math::Vector<Real>;
pub(super) type Point = math::Point<Real>;
pub(super) type AngVector = math::AngVector<Real>;

/// Whether no part of a pose is infinite or NaN.
pub(super) fn is_finite(pose: &Isometry<Real>) -> bool {
    let matrix = pose.to_homogeneous();
    matrix.iter().all(|entry| entry.is_finite())
}

/// The contacts of a pair.
pub(super) fn manifolds(pair: &ContactPair) -> &[ContactManifold] {
    &pair.manifolds
}

/// A step asks no tree.
pub(super) fn on_rapiers_tree<B: BroadPhase>(broad_phase: B) -> B {
    broad_phase
}

impl<B: BroadPhase> BroadPhase for Clocked<B> {
    fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified: &[ColliderHandle],
        removed: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.time(|inner| inner.update(params, colliders, bodies, modified, removed, events));
    }
}
