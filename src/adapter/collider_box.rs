//! The box that a collider is to be tracked by, as Rapier's own broad phase computes it.

use super::dimension;
use super::outline::Outline;
use super::rapier::dynamics::{IntegrationParameters, RigidBody, RigidBodySet, RigidBodyVelocity};
use super::rapier::geometry::Collider;
use super::rapier::math::{DIM, Isometry, Real};
use super::rapier::parry::bounding_volume::BoundingVolume;
use crate::Aabb;

/// What the boxes of all colliders depend on.
#[derive(Clone, Copy)]
pub(super) struct Prediction {
    dt: Real,
    half_distance: Real,
}

impl Prediction {
    pub(super) fn new(params: &IntegrationParameters) -> Self {
        Self {
            dt: params.dt,
            half_distance: params.prediction_distance() / 2.0,
        }
    }

    /// The collider's box, loosened by its contact skin and half the prediction distance, and stretched to
    /// where soft CCD expects the body at the end of the step.
    ///
    /// See `BroadPhaseBvh::update` in Rapier 0.27: nearer than the prediction distance, two such boxes touch.
    #[inline(always)]
    pub(super) fn collider_box(
        &self,
        collider: &Collider,
        outline: &mut Outline,
        bodies: &RigidBodySet,
    ) -> Aabb<Real, DIM> {
        let mut aabb = outline.aabb(collider);
        if let Some(body) = collider.parent().and_then(|parent| bodies.get(parent)) {
            if body.soft_ccd_prediction() > 0.0 {
                aabb = self.swept_box(collider, body);
            }
        }
        // Parry would panic at a negative distance or NaN.
        let distance = (collider.contact_skin() + self.half_distance).max(0.0);
        aabb.loosened(distance)
    }

    /// The box of the collider here and where its body is predicted to be.
    #[cold]
    fn swept_box(&self, collider: &Collider, body: &RigidBody) -> Aabb<Real, DIM> {
        let mut swept = collider.compute_aabb();
        if let Some(local_pose) = collider.position_wrt_parent() {
            let pose = predicted_pose(body, self.dt, body.soft_ccd_prediction()) * local_pose;
            swept.merge(&collider.shape().compute_aabb(&pose));
        }
        Aabb::new(swept.mins.coords.into(), swept.maxs.coords.into())
    }
}

/// Where the body will be after `dt` seconds, or after its centre of mass has gone `reach` length units.
///
/// Rapier keeps its own version of this private, so the velocity that it would use is read off the motion
/// that it does predict. A body that turns more than half a circle a step, and moves farther than its
/// `reach`, is predicted at another angle than there.
fn predicted_pose(body: &RigidBody, dt: Real, reach: Real) -> Isometry<Real> {
    let (start, center) = (body.position(), body.local_center_of_mass());
    let end = body.predict_position_using_velocity_and_forces(dt);
    let travel = (end * center) - (start * center);
    let distance = travel.norm();
    if distance <= reach {
        return end;
    }
    let turn = dimension::scaled_axis(&(end.rotation * start.rotation.inverse()));
    RigidBodyVelocity::new(travel, turn).integrate(reach / distance, start, center)
}
