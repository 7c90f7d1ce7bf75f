//! The code for Rapier 0.36, which has no trait for broad phases except in a patched copy (`seam.rs`).

use super::adapter::{Input, Trial, UnisizeBroadPhase};
use super::rapier::dynamics::{IntegrationParameters, RigidBodySet};
use super::rapier::geometry::{
    Aabb as RapierAabb, BroadPhasePairEvent, Collider, ColliderHandle, ColliderSet,
    InteractionGroups, InteractionTestMode,
};
use super::rapier::math::{DIM, Real};
use super::rapier::parry::shape::HalfSpace;
use super::rapier::parry::utils::PoseOps;
use crate::aabb::Aabb;
use crate::pair_filter::PairFilter;

pub(super) use super::rapier::math::{Pose, Vector};

/// The margin of Rapier's own broad phase, in multiples of the length unit.
pub(super) const MARGIN: Real = 0.04;

/// Whether Rapier's own broad phase reinserts a collider, without a margin, when its groups or body change.
pub(super) const REINSERTS: bool = true;

/// The default filter.
pub(super) const PAIR_FILTER: PairFilter = PairFilter::Shapes;

/// The filter at which the pairs are those of Rapier's own broad phase.
pub(super) const FILTER_OF_OWN: PairFilter = PairFilter::Groups;

/// The number of interleaved runs of the pairs that begin. The solver processes contacts in groups in which no two share a body.
pub(super) const RUNS: usize = 1;

/// Whether it is enough that one of two groups is in the filter of the other, if both groups are of this kind.
#[inline(always)]
pub(super) fn is_either_enough(groups: &InteractionGroups) -> bool {
    groups.test_mode == InteractionTestMode::Or
}

/// The origin of a pose.
#[inline(always)]
pub(super) fn origin(pose: &Pose) -> Vector {
    pose.translation
}

/// The norm squared of the rotation of a pose.
#[inline(always)]
pub(super) fn norm_squared(pose: &Pose) -> Real {
    pose.rotation.length_squared()
}

/// The half extents of the axis-aligned box around a rotated box with these half extents.
#[inline(always)]
pub(super) fn rotated_extent(pose: &Pose, half_extents: &Vector) -> Vector {
    pose.absolute_transform_vector(*half_extents)
}

/// The outward normal of a half-space.
pub(super) fn normal(half_space: &HalfSpace) -> Vector {
    half_space.normal
}

/// The box of a collider with soft CCD or without a simple shape, loosened by this distance.
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
    /// Updates boxes and pairs, and appends the changes of the pair set to `events`. The counterpart of `BroadPhaseBvh::update`, with the same
    /// arguments.
    ///
    /// `modified_colliders` are the colliders that are new, or whose pose, shape, parent, groups, active collision types, contact skin,
    /// hooks or enabled state may have changed since the last call; and those of a body whose type or soft CCD may have changed.
    /// `removed_colliders` are those that are gone; their pairs end without an event.
    ///
    /// By default, no pair is reported that the narrow phase would drop, as with Rapier's own broad phase, and no pair whose shapes cannot meet:
    /// see [`PairFilter::Shapes`](crate::PairFilter::Shapes). When a forbidden pair becomes allowed, the next update that lists one of the two as
    /// modified reports it. When a reported pair becomes forbidden, it stays until the boxes part, as with Rapier's own broad phase.
    ///
    /// The type's documentation has complexity, order of events and errors.
    pub fn update(
        &mut self,
        params: &IntegrationParameters,
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
        modified_colliders: &[ColliderHandle],
        removed_colliders: &[ColliderHandle],
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let (modified, removed) = (modified_colliders, removed_colliders);
        self.run(
            &Input::new(params, colliders, bodies, modified, removed),
            events,
        );
    }

    /// Sets the box of a collider that has moved, instead of listing the collider as modified. The next [`update`](Self::update) counts it as
    /// modified without reading it. Queries see the box at once. The counterpart of `BroadPhaseBvh::set_aabb`, which Rapier calls at the end of
    /// each step for every collider that the step has moved. Computes in **O(1)** time.
    ///
    /// `aabb` is the box of `Collider::compute_broad_phase_aabb`, or one that contains it. If it is not inside the current box, it is loosened
    /// by the margin and takes its place. Only the pose of the collider may have changed, by a rotation of unit length; list it as modified after
    /// any other change.
    ///
    /// If the collider is unknown, the next update reads the rest from the set. The box is ignored if a newer collider has the index. A collider
    /// with an invalid box is left out, and counted in [`Stats::refused`](crate::Stats::refused), until it gets a valid one.
    pub fn set_aabb(
        &mut self,
        params: &IntegrationParameters,
        handle: ColliderHandle,
        aabb: RapierAabb,
    ) {
        self.set_aabbs(params, &[(handle, aabb)]);
    }

    /// Sets many boxes, like [`set_aabb`](Self::set_aabb) for one after the other, but faster. Computes in **O(boxes)** time.
    pub fn set_aabbs(
        &mut self,
        params: &IntegrationParameters,
        aabbs: &[(ColliderHandle, RapierAabb)],
    ) {
        self.set_boxes(params, aabbs);
    }
}

impl Trial {
    /// Observes a world that runs on an unpatched Rapier: call this after each step. Computes in **O(colliders)** time, plus the updates.
    ///
    /// Both a second instance of Rapier's broad phase and unisize receive the boxes of all enabled colliders. The pairs are those that they
    /// would have in the world. The times are those of a world that never sleeps. At [`PairFilter::Shapes`], a collider keeps the kind of volume
    /// that it had at first, even if it is a ball that gets another shape, gets hooks, or if its body gets soft CCD or its 33rd collider.
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
        let observed = handles.map(|handle| (handle, Self::key(&colliders[handle], bodies)));
        let former = std::mem::replace(&mut self.observed, observed.collect());
        // A change of the filter key is not reported, so the collider is removed and inserted.
        let gone = former
            .iter()
            .filter(|&(handle, key)| self.observed.get(handle) != Some(key));
        let removed: Vec<_> = gone.map(|(handle, _)| *handle).collect();
        // Removals come first, because another collider may have the index now.
        let input = Input::new(params, colliders, bodies, &[], &removed);
        self.run(&input, &mut Vec::new());
        self.set_boxes(params, &aabbs);
        let input = Input::new(params, colliders, bodies, &[], &[]);
        self.run(&input, &mut Vec::new());
    }

    /// Sets boxes in all broad phases, as a part of the next update.
    pub(crate) fn set_boxes(
        &mut self,
        params: &IntegrationParameters,
        aabbs: &[(ColliderHandle, RapierAabb)],
    ) {
        let (allocated, no_events) = (self.allocated, &mut Vec::new());
        self.own_measured.run(allocated, no_events, |_| {
            for (handle, aabb) in aabbs {
                self.own.set_aabb(params, *handle, *aabb);
            }
        });
        for (broad_phase, measured) in self.tried.iter_mut().zip(&mut self.measured) {
            measured.run(allocated, no_events, |_| {
                broad_phase.set_boxes(params, aabbs);
            });
        }
    }
}
