//! The box that a collider is to be tracked by, as Rapier's own broad phase computes it.

use super::outline::Outline;
use super::rapier::dynamics::{IntegrationParameters, RigidBodySet};
use super::rapier::geometry::Collider;
use super::rapier::math::{DIM, Real};
use super::version;
use crate::Aabb;

/// What the boxes of all colliders depend on.
#[derive(Clone, Copy)]
pub(super) struct Prediction<'a> {
    params: &'a IntegrationParameters,
    half_distance: Real,
}

impl<'a> Prediction<'a> {
    pub(super) fn new(params: &'a IntegrationParameters) -> Self {
        Self {
            params,
            half_distance: params.prediction_distance() / 2.0,
        }
    }

    /// The collider's box, loosened by its contact skin and half the prediction distance, and stretched to
    /// where soft CCD expects the body at the end of the step.
    ///
    /// See `BroadPhaseBvh::update` in Rapier 0.27 and `Collider::compute_broad_phase_aabb` in 0.36: nearer than the
    /// prediction distance, two such boxes touch.
    #[inline(always)]
    pub(super) fn collider_box(
        &self,
        collider: &Collider,
        outline: &mut Outline,
        bodies: &RigidBodySet,
    ) -> Aabb<Real, DIM> {
        // Parry would panic at a negative distance or NaN.
        let mut distance = (collider.contact_skin() + self.half_distance).max(0.0);
        let outlined = outline.aabb(collider);
        let body = collider.parent().and_then(|parent| bodies.get(parent));
        let is_swept = body.is_some_and(|body| body.soft_ccd_prediction() > 0.0);
        // Both ways meet again, or the compiler does without vectors in the usual one.
        let aabb = match outlined {
            Some(aabb) if !is_swept => aabb,
            _ => {
                let aabb = version::unusual_box(collider, bodies, self.params, distance);
                distance = 0.0;
                aabb
            }
        };
        aabb.loosened(distance)
    }
}
