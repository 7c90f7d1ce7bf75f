//! Reads colliders: their boxes as Rapier's own broad phase computes them, their filter keys and their volumes.

use super::Input;
use super::collider_key::ColliderKey;
use super::outline::{Outline, Silent, off_unit};
use super::rapier::dynamics::{RigidBody, RigidBodySet};
use super::rapier::geometry::{Aabb as RapierAabb, Collider, ColliderHandle};
use super::rapier::math::{DIM, Real};
use super::version;
use crate::aabb::Aabb;
use crate::pair_filter::PairFilter;
use crate::proxy_table::{BoxSource, Handle};
use crate::volume::Volume;

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

/// The colliders of an update as a source of boxes.
pub(super) struct ColliderBoxes<'a> {
    input: Input<'a>,
    /// Half the prediction distance.
    half_distance: Real,
    /// The distance by which volumes are extended, at least that.
    reach: Real,
    filter: PairFilter,
}

impl<'a> ColliderBoxes<'a> {
    /// `reach_for` returns the distance by which volumes are extended, given that for boxes.
    pub(super) fn new(
        input: Input<'a>,
        filter: PairFilter,
        reach_for: impl FnOnce(Real) -> Real,
    ) -> Self {
        let half_distance = input.params.prediction_distance() / 2.0;
        Self {
            input,
            half_distance,
            reach: reach_for(half_distance),
            filter,
        }
    }
}

/// The body of a collider, if it has one.
#[inline(always)]
pub(super) fn body_of<'a>(collider: &Collider, bodies: &'a RigidBodySet) -> Option<&'a RigidBody> {
    bodies.get(collider.parent()?)
}

/// The volume of a collider in this box, extended by `reach`.
///
/// A collider with hooks has none, because a hook may count the pairs that it is asked about, or keep state for them.
#[inline(always)]
pub(super) fn volume(
    collider: Option<&Collider>,
    reach: Real,
    outline: &mut Outline,
    aabb: &Aabb<Real, DIM>,
) -> Volume<Real, DIM> {
    match collider {
        Some(collider) if collider.active_hooks().is_empty() => {
            let volume = outline.volume(collider, distance(collider, reach));
            volume.in_box(aabb)
        }
        _ => Volume::BOX,
    }
}

/// The maximum number of colliders of a body for which they have volumes. Most colliders of a larger body lie in its interior, so the volumes of
/// the few near other bodies do not pay for the rest: with volumes, steps of three ships of 1,728 cubes take half as long again. Events depend
/// on this number.
const MOST_WITH_VOLUMES: usize = 32;

/// The distance by which the box of a collider is loosened. Parry would panic at a negative one or a NaN.
#[inline(always)]
fn distance(collider: &Collider, half_distance: Real) -> Real {
    (collider.contact_skin() + half_distance).max(0.0)
}

impl BoxSource<Real, DIM> for ColliderBoxes<'_> {
    type Handle = ColliderHandle;
    type Memo = Outline;
    type Key = ColliderKey;

    #[inline(always)]
    fn skips_unbounded(&self) -> bool {
        self.input.skips_unbounded
    }

    fn has_keys(&self) -> bool {
        ColliderKey::differ(self.filter)
    }

    fn has_volumes(&self) -> bool {
        self.filter == PairFilter::Shapes
    }

    #[inline(always)]
    fn volume(
        &self,
        handle: ColliderHandle,
        outline: &mut Outline,
        aabb: &Aabb<Real, DIM>,
    ) -> Volume<Real, DIM> {
        let collider = self.input.colliders.get(handle);
        let body = collider.and_then(|collider| body_of(collider, self.input.bodies));
        // With soft CCD, contacts reach as far as the body will move, and a change of its velocity is not reported.
        let has_volume = |body: &RigidBody| {
            body.colliders().len() <= MOST_WITH_VOLUMES && body.soft_ccd_prediction() <= 0.0
        };
        // A kinematic body takes such a rotation as it is, and then only the box of a ball is passed.
        let is_off_unit = |body: &RigidBody| {
            body.is_kinematic() && off_unit(version::norm_squared(body.next_position())).is_none()
        };
        match body.is_none_or(has_volume) {
            true if body.is_some_and(is_off_unit) => Volume::BOX,
            true => volume(collider, self.reach, outline, aabb),
            false => Volume::PART,
        }
    }

    fn reach(&self) -> Real {
        self.reach
    }

    #[inline(always)]
    fn has_changed_unmoved(
        &self,
        handle: ColliderHandle,
        outline: &Outline,
        key: &ColliderKey,
    ) -> bool {
        let collider = self.input.colliders.get(handle);
        collider.is_some_and(|collider| {
            outline.silent != Some(Silent::of(collider))
                || !outline.may_be_of(collider.shared_shape())
                || !key.may_be_of(self.filter, collider)
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
    ) -> Option<(Aabb<Real, DIM>, ColliderKey)> {
        let Input {
            params,
            colliders,
            bodies,
            ..
        } = self.input;
        let collider = colliders.get(handle)?;
        if !collider.is_enabled() {
            return None;
        }
        let mut distance = distance(collider, self.half_distance);
        outline.silent = Some(Silent::of(collider));
        let outlined = outline.aabb(collider);
        let body = body_of(collider, bodies);
        let is_swept = body.is_some_and(|body| body.soft_ccd_prediction() > 0.0);
        // The compiler vectorizes the common branch only if both join before the box is loosened.
        let aabb = match outlined {
            Some(aabb) if !is_swept => aabb,
            _ => {
                let aabb = version::unusual_box(collider, bodies, params, distance);
                distance = 0.0;
                aabb
            }
        };
        let key = ColliderKey::new(self.filter, collider, body);
        Some((aabb.loosened(distance), key))
    }
}
