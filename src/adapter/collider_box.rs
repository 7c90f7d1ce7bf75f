//! Reads colliders: their boxes as Rapier's own broad phase computes them, their filter keys and their volumes.

use super::Input;
use super::collider_key::ColliderKey;
use super::outline::{Outline, off_unit};
use super::rapier::dynamics::{RigidBody, RigidBodySet};
use super::rapier::geometry::{Aabb as RapierAabb, Collider, ColliderHandle};
use super::rapier::math::{DIM, Real};
use super::version;
use crate::aabb::Aabb;
use crate::proxy_table::{ColliderSource, Handle, Reading};
use crate::volume::{Volume, VolumeKind};

impl From<RapierAabb> for Aabb<Real, DIM> {
    fn from(aabb: RapierAabb) -> Self {
        Self::new(aabb.mins.into(), aabb.maxs.into())
    }
}

impl From<Aabb<Real, DIM>> for RapierAabb {
    fn from(aabb: Aabb<Real, DIM>) -> Self {
        Self::new(aabb.mins.into(), aabb.maxs.into())
    }
}

impl Handle for ColliderHandle {
    fn from_raw_parts(slot: u32, generation: u32) -> Self {
        Self::from_raw_parts(slot, generation)
    }

    fn into_raw_parts(self) -> (u32, u32) {
        self.into_raw_parts()
    }
}

/// The body of a collider, if it has one.
#[inline(always)]
pub(super) fn body_of<'a>(collider: &Collider, bodies: &'a RigidBodySet) -> Option<&'a RigidBody> {
    bodies.get(collider.parent()?)
}

/// The maximum number of colliders of a body for which they have volumes. Most colliders of a larger body lie in its interior, so the volumes of
/// the few near other bodies do not pay for the rest: with volumes, steps of three ships of 1,728 cubes take 1.5 times as long. Events depend
/// on this number.
const MOST_WITH_VOLUMES: usize = 32;

/// The distance by which the box of a collider is loosened. Parry would panic at a negative one or a NaN.
#[inline(always)]
fn distance(collider: &Collider, half_distance: Real) -> Real {
    (collider.contact_skin() + half_distance).max(0.0)
}

/// The kind of the volume of a collider, if it is a box whatever the shape is. `None`: that of its shape.
#[inline(always)]
fn without_volume(collider: &Collider, body: Option<&RigidBody>) -> Option<VolumeKind> {
    // With soft CCD, contacts reach as far as the body will move, and a change of its velocity is not reported.
    let has_none = |body: &RigidBody| {
        body.colliders().len() > MOST_WITH_VOLUMES || body.soft_ccd_prediction() > 0.0
    };
    // A kinematic body takes any rotation as it is.
    let is_off_unit = |body: &RigidBody| {
        body.is_kinematic() && off_unit(version::norm_squared(body.next_position())).is_none()
    };
    // A hook may count the pairs that it is asked about, or keep state for them.
    let has_hooks = !collider.active_hooks().is_empty();
    match body {
        Some(body) if has_none(body) => Some(VolumeKind::BoxUntilRead),
        Some(body) if is_off_unit(body) => Some(VolumeKind::Box),
        _ => has_hooks.then_some(VolumeKind::Box),
    }
}

/// The colliders of an update as a source of boxes and volumes.
impl ColliderSource<Real, DIM> for Input<'_> {
    type Handle = ColliderHandle;
    type Memo = Outline;
    type Key = ColliderKey;

    #[inline(always)]
    fn volume(
        &self,
        handle: ColliderHandle,
        outline: &Outline,
        extension: Real,
    ) -> Volume<Real, DIM> {
        let Some(collider) = self.colliders.get(handle) else {
            return Volume::BOX;
        };
        if let Some(kind) = outline.without_volume {
            return Volume {
                kind,
                ..Volume::BOX
            };
        }
        let volume = outline.volume(collider, distance(collider, extension));
        let aabb = outline.aabb(collider);
        match aabb.filter(|_| volume.kind == VolumeKind::Ball) {
            None => volume,
            // Exactly as if it followed its box.
            Some(aabb) => {
                let aabb = aabb.loosened(distance(collider, self.reach()));
                let shortfall = (extension - self.reach()).max(0.0);
                Volume {
                    ball: volume.ball.in_box(&aabb.loosened(shortfall)),
                    ..volume
                }
            }
        }
    }

    fn reach(&self) -> Real {
        self.params.prediction_distance() / 2.0
    }

    #[inline(always)]
    fn has_changed_unmoved(
        &self,
        handle: ColliderHandle,
        outline: &Outline,
        key: &ColliderKey,
    ) -> bool {
        let collider = self.colliders.get(handle);
        collider.is_some_and(|collider| {
            outline.has_changed(collider) || !key.may_be_of(self.filter, collider)
        })
    }

    /// The box is loosened by the contact skin and half the prediction distance, so the boxes of two colliders within that distance touch.
    /// With soft CCD it extends to the position that Rapier predicts for the end of the step. See `BroadPhaseBvh::update` in Rapier 0.27
    /// and `Collider::compute_broad_phase_aabb` in 0.36.
    #[inline(always)]
    fn read(
        &self,
        handle: ColliderHandle,
        outline: &mut Outline,
    ) -> Option<Reading<Real, DIM, ColliderKey>> {
        let collider = self.colliders.get(handle)?;
        if !collider.is_enabled() {
            return None;
        }
        let mut distance = distance(collider, self.reach());
        let has_changed = outline.note(collider);
        let outlined = outline.aabb(collider);
        let body = body_of(collider, self.bodies);
        let kind = without_volume(collider, body);
        let former = std::mem::replace(&mut outline.without_volume, kind);
        let is_swept = body.is_some_and(|body| body.soft_ccd_prediction() > 0.0);
        // The compiler vectorizes the common branch only if both join before the box is loosened.
        let aabb = match outlined {
            Some(aabb) if !is_swept => aabb,
            _ => {
                let aabb = version::unusual_box(collider, self.bodies, self.params, distance);
                distance = 0.0;
                aabb
            }
        };
        let is_off_unit = off_unit(version::norm_squared(collider.position())).is_none();
        let has_no_volume = [former, kind] != [None; 2];
        let aabb = aabb.loosened(distance);
        Some(Reading {
            aabb,
            key: ColliderKey::new(self.filter, collider, body),
            has_only_moved: !(has_changed | is_off_unit | has_no_volume),
            is_skipped: self.skips_unbounded && aabb.is_unbounded(),
        })
    }
}
