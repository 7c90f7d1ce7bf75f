//! The code for Rapier 0.27, where [`BroadPhase`] is a trait.

use super::adapter::{Input, Trial, UnisizeBroadPhase};
use super::rapier::dynamics::{
    IntegrationParameters, RigidBody, RigidBodyPosition, RigidBodySet, RigidBodyVelocity,
};
use super::rapier::geometry::{
    BroadPhase, BroadPhasePairEvent, Collider, ColliderHandle, ColliderSet, InteractionGroups,
};
use super::rapier::math::{DIM, Isometry, Real};
use super::rapier::na::Normed;
use super::rapier::parry::bounding_volume::BoundingVolume;
use super::rapier::parry::shape::HalfSpace;
use super::rapier::parry::utils::IsometryOps;
use crate::aabb::Aabb;
use crate::pair_filter::PairFilter;

pub(super) type Pose = Isometry<Real>;
pub(super) type Vector = super::rapier::math::Vector<Real>;

/// The margin of Rapier's own broad phase, in multiples of the length unit.
pub(super) const MARGIN: Real = 0.01;

/// Whether Rapier's own broad phase reinserts a collider, without a margin, when its groups or body change.
pub(super) const REINSERTS: bool = false;

/// The default filter.
pub(super) const PAIR_FILTER: PairFilter = PairFilter::Off;

/// The filter at which the pairs are those of Rapier's own broad phase.
pub(super) const FILTER_OF_OWN: PairFilter = PairFilter::Off;

/// The number of interleaved runs of the pairs that begin. Without SIMD, the solver processes one contact after the other.
pub(super) const RUNS: usize = 2;

/// Whether it is enough that one of two groups is in the filter of the other.
pub(super) fn is_either_enough(_: &InteractionGroups) -> bool {
    false
}

/// The origin of a pose.
#[inline(always)]
pub(super) fn origin(pose: &Isometry<Real>) -> Vector {
    pose.translation.vector
}

/// The norm squared of the rotation of a pose.
#[inline(always)]
pub(super) fn norm_squared(pose: &Isometry<Real>) -> Real {
    Normed::norm_squared(pose.rotation.as_ref())
}

/// The half extents of the axis-aligned box around a rotated box with these half extents.
#[inline(always)]
pub(super) fn rotated_extent(pose: &Isometry<Real>, half_extents: &Vector) -> Vector {
    pose.absolute_transform_vector(half_extents)
}

/// The outward normal of a half-space.
pub(super) fn normal(half_space: &HalfSpace) -> Vector {
    *half_space.normal
}

/// The box of a collider with soft CCD or without a simple shape, loosened by this distance.
#[inline(never)]
pub(super) fn unusual_box(
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

/// The predicted pose of a body after `dt` seconds, or after its center of mass has travelled `max_travel` length units if that is sooner.
///
/// Rapier's version of this function is private, so this one derives the velocity from a motion that Rapier does predict. The predicted angle
/// differs from Rapier's if the body turns by more than half a circle in a step and moves farther than `max_travel`.
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

macro_rules! impl_broad_phase {
    ($($name:ident)*) => {$(
        impl BroadPhase for $name {
            fn update(
                &mut self,
                params: &IntegrationParameters,
                colliders: &ColliderSet,
                bodies: &RigidBodySet,
                modified_colliders: &[ColliderHandle],
                removed_colliders: &[ColliderHandle],
                events: &mut Vec<BroadPhasePairEvent>,
            ) {
                let (modified, removed) = (modified_colliders, removed_colliders);
                self.run(&Input::new(params, colliders, bodies, modified, removed), events);
            }
        }
    )*};
}

impl_broad_phase!(UnisizeBroadPhase Trial);
