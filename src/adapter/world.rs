//! What colliders are read from, and what comes of reading one.

use super::collider_box::Prediction;
use super::outline::Outline;
use super::rapier::dynamics::RigidBodySet;
use super::rapier::geometry::{Collider, ColliderSet};
use super::rapier::math::{DIM, Real};
use crate::Aabb;

/// What colliders are read from, and how.
pub(super) struct World<'a> {
    pub(super) colliders: &'a ColliderSet,
    pub(super) bodies: &'a RigidBodySet,
    pub(super) prediction: Prediction<'a>,
    /// How far a box that is renewed reaches beyond the collider, in length units of the scene.
    pub(super) margin: Real,
}

impl World<'_> {
    /// The box of a collider, without the margin.
    #[inline(always)]
    pub(super) fn collider_box(
        &self,
        collider: &Collider,
        outline: &mut Outline,
    ) -> Aabb<Real, DIM> {
        self.prediction.collider_box(collider, outline, self.bodies)
    }

    /// What to do with a proxy whose box is `held` and should be around `aabb`: nothing, or to put this new box in its
    /// place, or, with `Some(None)`, something else, because one of the two is not valid.
    #[inline(always)]
    pub(super) fn renewed(
        &self,
        held: &Aabb<Real, DIM>,
        aabb: &Aabb<Real, DIM>,
    ) -> Option<Option<Aabb<Real, DIM>>> {
        // Which side is passed first is as good as random: one branch on all of them is foreseen better than one on
        // each, which the compiler would make of it otherwise.
        if std::hint::black_box(held.contains(aabb) & aabb.is_valid()) {
            return None;
        }
        if !(held.is_valid() & aabb.is_valid()) {
            return Some(None);
        }
        let loosened = aabb.loosened(self.margin);
        // An infinite side less an infinite margin would be NaN.
        Some(Some(if loosened.is_valid() { loosened } else { *aabb }))
    }
}
