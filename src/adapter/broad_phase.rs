//! The broad phase itself: Rapier's lists of colliders in, Rapier's pair events out.

use super::Settings;
use super::collider_box::{ColliderBoxes, volume};
use super::collider_key::ColliderKey;
use super::outline::Outline;
use super::query_tree::QueryTree;
use super::rapier::dynamics::{IntegrationParameters, RigidBodySet};
use super::rapier::geometry::{
    Aabb as RapierAabb, BroadPhasePairEvent, ColliderHandle, ColliderPair, ColliderSet,
};
use super::rapier::math::{DIM, Real};
use super::version;
use crate::diagnostics::Diagnostics;
use crate::overrides::Overrides;
use crate::pair_filter::PairFilter;
use crate::parallel;
use crate::proxy_table::{Changes, IsActive, Lists, ProxyTable};
use crate::stats::Stats;

/// A broad phase for scenes of many colliders of about the same size. In Rapier 0.27, give it to `PhysicsPipeline::step`
/// or `CollisionPipeline::step` in place of `DefaultBroadPhase`. In Rapier 0.36, pass it to `DefaultBroadPhase::custom` on a
/// patched copy, or call its `update` yourself.
///
/// It keeps a box for every enabled collider, the same that Rapier's own broad phase keeps, and reports every pair whose boxes
/// overlap, except those that the [filter](PairFilter) leaves out because they can have no effect. Contacts, intersections and the
/// bodies that are woken are therefore the same.
///
/// An update in which no collider has left its margin costs one box comparison for each listed collider. Pairs are
/// searched for some updates ahead, so most updates only compare boxes that are known to be near each other. What moves
/// otherwise than foreseen is looked up among the others in about **O(log n)** each; where that is much, there is one
/// search over all boxes.
///
/// The events of an update come in one order, however they were found: first pairs that end, then pairs that begin, each by the
/// smaller index of the two colliders and then by the larger one. In Rapier 0.27 those that begin are cut
/// in two halves, whose pairs alternate: its solver is faster so.
#[derive(Clone)]
pub struct UnisizeBroadPhase {
    pub(super) table: ProxyTable<Real, DIM, Outline, ColliderKey>,
    pub(super) settings: Settings,
    /// Scratch: how pairs have changed.
    pub(super) changes: Changes,
    pub(super) query_tree: QueryTree,
    /// For the last update, the listed colliders that the narrow phase would have woken if it had been told of all pairs whose boxes
    /// overlap, alone, and with each of their neighbors.
    pub(crate) unreported: Vec<(ColliderHandle, Option<ColliderHandle>)>,
}

/// What an update is given.
#[derive(Clone, Copy)]
pub(crate) struct Input<'a> {
    pub(crate) params: &'a IntegrationParameters,
    pub(crate) colliders: &'a ColliderSet,
    pub(crate) bodies: &'a RigidBodySet,
    pub(crate) lists: Lists<'a, ColliderHandle>,
    /// Those of the listed colliders whose change the narrow phase feels.
    pub(crate) felt: &'a [ColliderHandle],
    /// Whether the narrow phase has an active contact or an intersection of two colliders, if it can be asked.
    pub(crate) is_active: Option<IsActive<'a, ColliderHandle>>,
}

impl<'a> Input<'a> {
    pub(crate) fn new(
        params: &'a IntegrationParameters,
        colliders: &'a ColliderSet,
        bodies: &'a RigidBodySet,
        lists: Lists<'a, ColliderHandle>,
    ) -> Self {
        Self {
            params,
            colliders,
            bodies,
            lists,
            felt: &[],
            is_active: None,
        }
    }
}

impl std::fmt::Debug for UnisizeBroadPhase {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("UnisizeBroadPhase")
            .field("settings", &self.settings)
            .field("stats", &self.stats())
            .finish_non_exhaustive()
    }
}

impl Default for UnisizeBroadPhase {
    fn default() -> Self {
        Self::with_settings(Settings::default())
    }
}

impl UnisizeBroadPhase {
    /// The margin that boxes have by default, that of Rapier's own broad phase, in multiples of the length unit. See
    /// [`Settings::margin`](crate::Settings::margin).
    pub const DEFAULT_MARGIN: Real = version::MARGIN;

    /// A broad phase without any colliders, with default [`Settings`].
    pub fn new() -> Self {
        Self::default()
    }

    /// A broad phase without any colliders.
    pub fn with_settings(settings: Settings) -> Self {
        Self {
            table: ProxyTable::new(&Self::resolved(settings)),
            settings,
            changes: Changes::new(version::RUNS),
            query_tree: QueryTree::default(),
            unreported: Vec::new(),
        }
    }

    /// Has the next step list all colliders, as if they had just been inserted. **O(colliders)**.
    ///
    /// A broad phase hears only of what changes, so one that takes another's place in a running world knows nothing of what rests there, and
    /// bodies fall through their floors. Whenever a broad phase is exchanged, to change its settings, after an old save was loaded, or for
    /// another kind of broad phase, exchange the narrow phase as well, whose pairs nobody would end, and call this:
    ///
    /// ```text
    /// broad_phase = UnisizeBroadPhase::with_settings(settings);
    /// narrow_phase = NarrowPhase::new();
    /// UnisizeBroadPhase::mark_all_modified(&mut colliders);
    /// ```
    ///
    /// It serves Rapier's own broad phase too. Contacts are found anew: their warm-start impulses are lost, and what touches is reported as a
    /// beginning collision once more.
    pub fn mark_all_modified(colliders: &mut ColliderSet) {
        let handles: Vec<_> = colliders.iter().map(|(handle, _)| handle).collect();
        for handle in handles {
            if let Some(collider) = colliders.get_mut(handle) {
                // Rapier's own broad phase looks at what has been moved.
                collider.set_position(*collider.position());
            }
        }
    }

    /// The settings it was made with.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// What it holds, and what the last update did. **O(1)**.
    pub fn stats(&self) -> Stats {
        self.table.stats()
    }

    /// What tests and studies ask beyond the statistics. **O(1)**.
    #[doc(hidden)]
    pub fn diagnostics(&self) -> Diagnostics {
        self.table.diagnostics()
    }

    /// Fixes what updates otherwise choose by themselves. Clones have the same overrides; a broad phase that was read from a snapshot has
    /// none.
    #[doc(hidden)]
    pub fn set_overrides(&mut self, overrides: Overrides) {
        self.table.set_overrides(overrides);
    }

    /// The pairs it holds, each once, the collider with the smaller index first, in no particular order.
    /// **O(pairs)** to go through.
    pub fn pairs(&self) -> impl Iterator<Item = ColliderPair> + '_ {
        let pairs = self.table.pairs();
        pairs.map(|[first, second]| ColliderPair::new(first, second))
    }

    /// The boxes by which pairs are searched for, drawn ahead of the motion of their colliders. For pictures.
    #[doc(hidden)]
    pub fn fat_boxes(&self) -> impl Iterator<Item = RapierAabb> + '_ {
        self.table.fat_boxes().map(|&aabb| aabb.into())
    }

    /// Checks the internal invariants: the records of colliders, the pairs held, by a full search, and the leaves of the tree for
    /// queries, if there is one. For tests.
    ///
    /// # Panics
    /// If an invariant is broken, which would be a bug.
    pub fn validate(&self) {
        self.table.validate();
        self.query_tree.validate(self.table.boxes());
    }

    /// Which pairs are left out.
    fn filter(&self) -> PairFilter {
        self.settings.filter.unwrap_or(version::PAIR_FILTER)
    }

    /// Settings with the default filter of this version of Rapier, where none is given.
    pub(super) fn resolved(settings: Settings) -> Settings {
        settings.with_filter(settings.filter.unwrap_or(version::PAIR_FILTER))
    }

    /// How far a renewed box extends beyond its collider, in length units of the scene.
    pub(crate) fn margin(&self, params: &IntegrationParameters) -> Real {
        let margin = self.settings.margin.unwrap_or(Self::DEFAULT_MARGIN);
        // NaN counts as 0 too.
        (margin * params.length_unit).max(0.0)
    }

    /// One update as by the pipelines of a patched Rapier 0.36, which then ask what is to be woken.
    pub(crate) fn update_in_pipeline(
        &mut self,
        input: &Input<'_>,
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        self.unreported.clear();
        for (listed, are_removed) in [(input.felt, false), (input.lists.removed, true)] {
            self.table.visit_unreported(listed, |collider, neighbor| {
                // Removing a collider wakes its body only for the sake of a pair.
                if neighbor.is_some() || !are_removed {
                    self.unreported.push((collider, neighbor));
                }
            });
        }
        self.bring_up_to_date(input, events);
    }

    /// Takes boxes that are handed over, as a part of the next update. Without the colliders, only balls keep their volumes.
    #[allow(dead_code, reason = "only Rapier 0.36 hands boxes over")]
    pub(crate) fn hand_over(
        &mut self,
        params: &IntegrationParameters,
        colliders: Option<&ColliderSet>,
        aabbs: &[(ColliderHandle, RapierAabb)],
    ) {
        if aabbs.is_empty() {
            return;
        }
        let margin = self.margin(params);
        parallel::enter(self.table.reading(aabbs.len()), || {
            let volume = |handle, outline: &mut _, aabb: &_| {
                let collider = colliders.and_then(|colliders| colliders.get(handle));
                volume(collider, params, outline, aabb)
            };
            let written = self.table.hand_over(aabbs, margin, volume);
            self.query_tree.note(written);
        });
    }

    /// One update.
    pub(crate) fn bring_up_to_date(
        &mut self,
        input: &Input<'_>,
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        if input.lists.are_empty() && !self.table.is_begun() {
            return;
        }
        let work = self.table.work_ahead(&input.lists);
        parallel::enter(work, || self.update_all(input, events));
    }

    fn update_all(&mut self, input: &Input<'_>, events: &mut Vec<BroadPhasePairEvent>) {
        let margin = self.margin(input.params);
        let boxes = ColliderBoxes {
            input: *input,
            half_distance: input.params.prediction_distance() / 2.0,
            filter: self.filter(),
        };
        let written = self.table.update(&input.lists, &boxes, margin);
        self.query_tree.note(written);
        self.query_tree.grow_older();
        let event = |is_added, [first, second]: [_; 2]| match is_added {
            true => BroadPhasePairEvent::AddPair(ColliderPair::new(first, second)),
            false => BroadPhasePairEvent::DeletePair(ColliderPair::new(first, second)),
        };
        let slack = 2.0 * margin;
        self.table.finish(
            slack,
            input.is_active,
            &mut self.changes,
            |is_added, pair| {
                events.push(event(is_added, pair));
            },
        );
    }
}
