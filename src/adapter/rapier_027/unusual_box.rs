//! The box of a collider in the unusual case: soft CCD, or a shape that is not simple.

use super::super::rapier::dynamics::{
    IntegrationParameters, RigidBody, RigidBodyPosition, RigidBodySet, RigidBodyVelocity,
};
use super::super::rapier::geometry::Collider;
use super::super::rapier::math::{DIM, Isometry, Real};
use super::super::rapier::parry::bounding_volume::BoundingVolume;
use crate::aabb::Aabb;

/// The box of a collider whose body soft CCD expects elsewhere at the end of the step, or whose shape is not simple,
/// loosened by this distance.
#[inline(never)]
pub(in super::super) fn unusual_box(
    collider: &Collider,
    bodies: &RigidBodySet,
    params: &IntegrationParameters,
    distance: Real,
) -> Aabb<Real, DIM> {
    let mut swept = collider.compute_aabb();
    let body = collider.parent().and_then(|parent| bodies.get(parent));
    if let (Some(body), Some(local_pose)) = (body, collider.position_wrt_parent()) {
        if body.soft_ccd_prediction() > 0.0 {
            let pose = predicted_pose(body, params.dt, body.soft_ccd_prediction()) * local_pose;
            swept.merge(&collider.shape().compute_aabb(&pose));
        }
    }
    Aabb::from(swept).loosened(distance)
}

/// Where the body will be after `dt` seconds, or once its centre of mass has travelled `max_travel` length units.
///
/// Rapier keeps its own version of this private, so the velocity that it would use is derived from the motion that it
/// does predict. A body that turns by more than half a circle in a step, and moves farther than its `max_travel`, is
/// predicted at another angle than in Rapier.
fn predicted_pose(body: &RigidBody, dt: Real, max_travel: Real) -> Isometry<Real> {
    let (start, center) = (body.position(), body.local_center_of_mass());
    let end = body.predict_position_using_velocity_and_forces(dt);
    let travel = (end * center) - (start * center);
    let distance = travel.norm();
    if distance <= max_travel {
        return end;
    }
    let motion = RigidBodyPosition {
        position: *start,
        next_position: end,
    };
    let turn = motion.interpolate_velocity(1.0, center).angvel;
    RigidBodyVelocity::new(travel, turn).integrate(max_travel / distance, start, center)
}
