//! The box that a collider is to be tracked by, as Rapier's own broad phase computes it.

use super::rapier::dynamics::{IntegrationParameters, RigidBody, RigidBodySet, RigidBodyVelocity};
use super::rapier::geometry::Collider;
use super::rapier::math::{DIM, Isometry, Real};
use super::rapier::parry::bounding_volume::BoundingVolume;
use crate::Aabb;

/// The collider's box, loosened by its contact skin and half the prediction distance, and stretched to where
/// soft CCD expects the body at the end of the step.
///
/// See `BroadPhaseBvh::update` in Rapier 0.27: nearer than the prediction distance, two such boxes touch.
pub(super) fn collider_box(
    collider: &Collider,
    bodies: &RigidBodySet,
    params: &IntegrationParameters,
) -> Aabb<Real, DIM> {
    let mut aabb = collider.compute_aabb();
    let body = collider.parent().and_then(|parent| bodies.get(parent));
    let reach = body.map_or(0.0, RigidBody::soft_ccd_prediction);
    if reach > 0.0 {
        if let (Some(body), Some(local_pose)) = (body, collider.position_wrt_parent()) {
            let pose = predicted_pose(body, params.dt, reach) * local_pose;
            aabb.merge(&collider.shape().compute_aabb(&pose));
        }
    }
    let distance = collider.contact_skin() + params.prediction_distance() / 2.0;
    // Parry would panic at a negative distance or NaN.
    Aabb::new(aabb.mins.coords.into(), aabb.maxs.coords.into()).loosened(distance.max(0.0))
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
    let turn = super::super::scaled_axis(&(end.rotation * start.rotation.inverse()));
    RigidBodyVelocity::new(travel, turn).integrate(reach / distance, start, center)
}
