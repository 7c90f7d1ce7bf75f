//! What the adapter needs of Rapier 0.36 in particular, which has no trait for broad phases unless a copy of it is opened
//! (`seam.rs`).

use super::adapter::{Input, Trial, UnisizeBroadPhase, key};
use super::rapier::dynamics::{IntegrationParameters, RigidBodySet};
#[cfg(test)]
use super::rapier::geometry::Group;
use super::rapier::geometry::{
    Aabb as RapierAabb, BroadPhasePairEvent, Collider, ColliderHandle, ColliderSet,
    InteractionGroups, InteractionTestMode,
};
use super::rapier::math::{DIM, Real};
#[cfg(test)]
use super::rapier::parry::query::intersection_test;
use super::rapier::parry::shape::HalfSpace;
use super::rapier::parry::utils::PoseOps;
use crate::aabb::Aabb;
use crate::pair_filter::PairFilter;
use crate::proxy_table::Lists;

pub(super) use super::rapier::math::{Pose, Vector};

/// The margin of Rapier's own broad phase, in multiples of the length unit.
pub(super) const MARGIN: Real = 0.04;

/// Whether Rapier's own broad phase inserts a collider afresh, without a margin, when its groups or body change.
pub(super) const REINSERTS: bool = true;

/// The default filter.
pub(super) const PAIR_FILTER: PairFilter = PairFilter::Shapes;

/// What Rapier's own broad phase leaves out.
pub(super) const FILTER_OF_OWN: PairFilter = PairFilter::Groups;

/// In how many runs pairs that begin take turns. Its solver takes contacts in groups in which no two share a body.
pub(super) const RUNS: usize = 1;

/// Whether groups meet others of this kind if either is in the filter of the other, and not only if both are.
#[inline(always)]
pub(super) fn is_either_enough(groups: &InteractionGroups) -> bool {
    groups.test_mode == InteractionTestMode::Or
}

/// The groups with these memberships and this filter.
#[cfg(test)]
pub(super) fn all_groups(memberships: Group, filter: Group) -> Vec<InteractionGroups> {
    let modes = [InteractionTestMode::And, InteractionTestMode::Or];
    let groups = modes.map(|mode| InteractionGroups::new(memberships, filter, mode));
    groups.to_vec()
}

/// Whether the shapes of two colliders intersect.
#[cfg(test)]
pub(super) fn intersect(a: &Collider, b: &Collider) -> bool {
    let test = intersection_test(a.position(), a.shape(), b.position(), b.shape());
    test.is_ok_and(|found| found.intersecting)
}

/// The origin of a pose.
#[inline(always)]
pub(super) fn origin(pose: &Pose) -> Vector {
    pose.translation
}

/// The half extents of the axis-aligned box around a rotated box with these half extents.
#[inline(always)]
pub(super) fn turned(pose: &Pose, half_extents: &Vector) -> Vector {
    pose.absolute_transform_vector(*half_extents)
}

/// The outward normal of a half-space.
pub(super) fn normal(half_space: &HalfSpace) -> Vector {
    half_space.normal
}

/// The vector from the origin to a point.
pub(super) fn coordinates(point: Vector) -> Vector {
    point
}

/// The box of a collider whose body soft CCD expects elsewhere at the end of the step, or whose shape is not simple,
/// loosened by this distance.
#[inline(never)]
pub(super) fn unusual_box(
    collider: &Collider,
    bodies: &RigidBodySet,
    params: &IntegrationParameters,
    distance: Real,
) -> Aabb<Real, DIM> {
    if collider.contact_skin() + params.prediction_distance() / 2.0 >= 0.0 {
        return collider.compute_broad_phase_aabb(params, bodies).into();
    }
    // Rapier would panic.
    Aabb::from(collider.compute_aabb()).loosened(distance)
}

impl UnisizeBroadPhase {
    /// Brings boxes and pairs up to date, and reports how the pairs have changed. The counterpart of
    /// `BroadPhaseBvh::update`, with the same arguments.
    ///
    /// `modified_colliders` are those that are new, or whose pose, shape, parent, groups or active collision types may
    /// have changed since the last call, or which may have been enabled or disabled; `removed_colliders` are those that
    /// are gone: their pairs end without an event.
    ///
    /// By default it reports no pairs that the narrow phase would drop, like Rapier's own, and none whose shapes cannot meet: see
    /// [`PairFilter::Shapes`](crate::PairFilter::Shapes). Once a pair that groups or types forbade is allowed, it is reported by the next update in
    /// which one of the two is listed as modified. A reported pair that they come to forbid stays until the boxes part, as with Rapier's
    /// own.
    pub fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified_colliders: &[ColliderHandle],
        removed_colliders: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let lists = Lists::new(modified_colliders, removed_colliders);
        self.bring_up_to_date(&Input::new(params, colliders, bodies, lists), events);
    }

    /// Hands over the box of a collider, in place of listing it as modified: in the next [`update`](Self::update) it counts
    /// as moved, and is not read again. The counterpart of `BroadPhaseBvh::set_aabb`, which Rapier calls for all that it
    /// has moved, at the end of each step. Queries see the box at once.
    ///
    /// `aabb` is that of `Collider::compute_broad_phase_aabb`, or at least contains it; the margin is added if the collider
    /// has left the box that is held. Only its position may have changed: for anything else it must be listed. A box for a
    /// collider that the broad phase does not know counts once the next update finds it in the set. A box for a collider whose
    /// index a newer one has is ignored. An invalid box leaves the collider out, as
    /// [`Stats::refused`](crate::Stats::refused), until a valid one comes. Only of a ball does the box tell
    /// where the shape is: other colliders are pairs by their boxes until they are listed. **O(1)**.
    pub fn set_aabb(
        &mut self,
        params: &IntegrationParameters,
        handle: ColliderHandle,
        aabb: RapierAabb,
    ) {
        self.set_aabbs(params, &[(handle, aabb)]);
    }

    /// Hands over many boxes, like [`set_aabb`](Self::set_aabb) one after the other, in less time.
    pub fn set_aabbs(
        &mut self,
        params: &IntegrationParameters,
        aabbs: &[(ColliderHandle, RapierAabb)],
    ) {
        self.hand_over(params, None, aabbs);
    }
}

impl Trial {
    /// Looks on while a world runs on a Rapier that is not patched: call it after each step. **O(colliders)**.
    ///
    /// The boxes of all enabled colliders are handed over, to another broad phase of Rapier's as well as to unisize. The pairs are as they
    /// would be; the times are those of a world that never sleeps. A collider that is given another shape has its former volume at
    /// [`PairFilter::Shapes`].
    pub fn observe(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
    ) {
        let enabled = colliders.iter_enabled();
        let boxes =
            enabled.map(|(handle, it)| (handle, it.compute_broad_phase_aabb(params, bodies)));
        let is_finite = |aabb: &RapierAabb| aabb.mins.is_finite() && aabb.maxs.is_finite();
        let aabbs: Vec<_> = boxes.filter(|(_, aabb)| is_finite(aabb)).collect();
        let handles = aabbs.iter().map(|(handle, _)| *handle);
        let seen = handles.map(|handle| (handle, key(&colliders[handle], bodies)));
        let former = std::mem::replace(&mut self.looked_at, seen.collect());
        // What may meet others than before comes anew, because nobody tells that it has changed.
        let gone = former
            .iter()
            .filter(|&(handle, key)| self.looked_at.get(handle) != Some(key));
        let removed: Vec<_> = gone.map(|(handle, _)| *handle).collect();
        // First, for another collider may have the index by now.
        let input = Input::new(params, colliders, bodies, Lists::new(&[], &removed));
        self.run(&input, &mut Vec::new());
        self.hand_over(params, Some(colliders), &aabbs);
        let input = Input::new(params, colliders, bodies, Lists::new(&[], &[]));
        self.run(&input, &mut Vec::new());
    }

    /// Hands over boxes to both.
    pub(crate) fn hand_over(
        &mut self,
        params: &IntegrationParameters,
        colliders: Option<&ColliderSet>,
        aabbs: &[(ColliderHandle, RapierAabb)],
    ) {
        self.prepare(
            |own| {
                for (handle, aabb) in aabbs {
                    own.set_aabb(params, *handle, *aabb);
                }
            },
            |tried| tried.hand_over(params, colliders, aabbs),
        );
    }
}
