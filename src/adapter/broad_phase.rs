//! The broad phase: takes Rapier's lists of colliders and returns Rapier's pair events.

use super::collider_key::ColliderKey;
use super::outline::Outline;
use super::query_tree::QueryTree;
use super::rapier::dynamics::{IntegrationParameters, RigidBodySet};
use super::rapier::geometry::{
    Aabb as RapierAabb, BroadPhasePairEvent, ColliderHandle, ColliderPair, ColliderSet,
};
use super::rapier::math::{DIM, Real};
use super::rapier::parry::partitioning::Bvh;
use super::rapier::parry::query::QueryDispatcher;
use super::rapier::pipeline::{QueryFilter, QueryPipeline, QueryPipelineMut};
use super::{Input, Settings, version};
use crate::pair_filter::PairFilter;
use crate::pair_tracker::Changes;
use crate::parallel;
use crate::proxy_table::{ColliderSource, ProxyTable};
use crate::stats::Stats;

/// An exact broad phase for Rapier, fast where many colliders are of about the same size.
///
/// In Rapier 0.27, pass it to `PhysicsPipeline::step` or `CollisionPipeline::step` in place of `DefaultBroadPhase`. In Rapier 0.36, pass it to
/// `DefaultBroadPhase::custom` on a patched copy, or call its `update` yourself.
///
/// # Pairs
///
/// The broad phase keeps a box for every enabled collider, in a pipeline the same box that Rapier's own broad phase keeps. It reports every
/// pair whose boxes overlap, except those that the [filter](PairFilter) leaves out because they can have no effect. Contacts, intersections
/// and woken bodies are therefore the same; [`PairFilter`] lists the exceptions.
///
/// # Events
///
/// The order of the events of an update depends only on boxes, filters and handles. The pairs that end come first, then those that begin,
/// both sorted by the smaller index of the two colliders and then by the larger one. In Rapier 0.27, whose solver is then faster, the pairs
/// that begin are split into two halves, which are interleaved.
///
/// # Complexity
///
/// An update with empty lists takes **O(1)** time, unless boxes were set. It takes **O(colliders)** if the prediction distance or the length
/// unit is larger than ever. For each listed collider an update compares one box. If colliders have left their margins, it also
/// compares the boxes of the pairs that an earlier search found. A search looks some updates ahead. A
/// collider that moves otherwise than predicted is looked up among the others in about **O(log n)** time. If there are many, the
/// [kernel](crate::GridSweep) searches all boxes, in about **O(n + pairs)** time. Memory is **O(n + pairs)**.
///
/// # Errors
///
/// No input makes an update panic. A collider whose box is inverted or has a NaN is left out until its box is valid again, and
/// [`Stats::refused`] counts it; the first one is logged as a warning. In the pipelines of Rapier 0.36, a collider whose box is infinite keeps
/// the box that it had, or is left out if it had none, as in Rapier's own broad phase.
#[derive(Clone)]
pub struct UnisizeBroadPhase {
    pub(super) table: ProxyTable<Real, DIM, Outline, ColliderKey>,
    pub(super) settings: Settings,
    /// Scratch: the changes of the pair set.
    pub(super) changes: Changes,
    pub(super) query_tree: QueryTree,
    /// The colliders that the last update in a pipeline has [found](ProxyTable::find_unreported), for the pipeline to wake.
    pub(crate) unreported: Vec<ColliderHandle>,
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
    /// The default margin of boxes, in multiples of the length unit: that of Rapier's own broad phase. See
    /// [`Settings::margin`](crate::Settings::margin).
    pub const DEFAULT_MARGIN: Real = version::MARGIN;

    /// Creates a broad phase without colliders, with default [`Settings`].
    pub fn new() -> Self {
        Self::default()
    }

    /// Creates a broad phase without colliders.
    pub fn with_settings(settings: Settings) -> Self {
        Self {
            table: ProxyTable::new(Self::filter(&settings) == PairFilter::Shapes),
            settings,
            changes: Changes::new(version::RUNS),
            query_tree: QueryTree::default(),
            unreported: Vec::new(),
        }
    }

    /// Marks all colliders as modified, so that the next step lists them as if they had just been inserted. Computes in **O(colliders)** time.
    ///
    /// Call this whenever you replace the broad phase of a running world, but not on a patched copy of Rapier 0.36, which lists all
    /// colliders itself. For example, its settings change, an old save was loaded, or another kind of broad phase takes its place. A broad
    /// phase only receives changes, so a new one does not know the colliders at rest, and bodies fall through their floors. Replace the
    /// narrow phase as well, because nothing else would end its pairs:
    ///
    /// ```text
    /// broad_phase = UnisizeBroadPhase::with_settings(settings);
    /// narrow_phase = NarrowPhase::new();
    /// UnisizeBroadPhase::mark_all_modified(&mut colliders);
    /// ```
    ///
    /// This works for Rapier's own broad phase too. The new narrow phase has no warm-start impulses, and reports each contact as a collision
    /// that begins.
    pub fn mark_all_modified(colliders: &mut ColliderSet) {
        for (_, collider) in colliders.iter_mut() {
            // Rapier's own broad phase reads the colliders whose position was set.
            collider.set_position(*collider.position());
        }
    }

    /// Returns the settings that the broad phase was created with.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Returns the current counts, and what the last update did. Computes in **O(1)** time.
    pub fn stats(&self) -> Stats {
        self.table.stats()
    }

    /// Returns the scene at the last update, and boxes that were set since, for queries. The counterpart of `BroadPhaseBvh::as_query_pipeline`.
    ///
    /// The first call builds a tree in **O(n log n)** time. The tree is kept while the program queries it. The first call after an update
    /// refreshes the tree, in about a tenth of the time of building it, or builds it again if it has become too loose. Other calls take
    /// **O(1)** time.
    ///
    /// The boxes in the tree are those of Rapier's own broad phase. If several colliders are at exactly the same distance, a query may find
    /// another one of them.
    pub fn as_query_pipeline<'a>(
        &'a self,
        dispatcher: &'a dyn QueryDispatcher,
        bodies: &'a RigidBodySet,
        colliders: &'a ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipeline<'a> {
        QueryPipeline {
            dispatcher,
            bvh: self.tree(),
            bodies,
            colliders,
            filter,
        }
    }

    /// Returns the same scene with the sets borrowed mutably. The counterpart of `BroadPhaseBvh::as_query_pipeline_mut`.
    pub fn as_query_pipeline_mut<'a>(
        &'a self,
        dispatcher: &'a dyn QueryDispatcher,
        bodies: &'a mut RigidBodySet,
        colliders: &'a mut ColliderSet,
        filter: QueryFilter<'a>,
    ) -> QueryPipelineMut<'a> {
        QueryPipelineMut {
            dispatcher,
            bvh: self.tree(),
            bodies,
            colliders,
            filter,
        }
    }

    pub(crate) fn tree(&self) -> &Bvh {
        self.query_tree.of(self.table.boxes())
    }

    /// Iterates over the current pairs in unspecified order, each once, with the smaller collider index first. Computes in **O(pairs)** time.
    pub fn pairs(&self) -> impl Iterator<Item = ColliderPair> + '_ {
        let pairs = self.table.pairs();
        pairs.map(|[first, second]| ColliderPair::new(first, second))
    }

    /// The boxes among which pairs are searched for, extended ahead of the motion of their colliders. For pictures.
    #[doc(hidden)]
    pub fn fat_boxes(&self) -> impl Iterator<Item = RapierAabb> + '_ {
        self.table.fat_boxes().map(|&aabb| aabb.into())
    }

    /// Checks the internal invariants, for tests: the records of colliders, the pairs against a full search, and the leaves of the query
    /// tree if there is one.
    ///
    /// # Panics
    ///
    /// Panics if an invariant is broken, which is a bug in this library.
    pub fn validate(&self) {
        self.table.validate();
        self.query_tree.validate(self.table.boxes());
    }

    /// The filter in the settings, or the default of this version of Rapier.
    pub(super) fn filter(settings: &Settings) -> PairFilter {
        settings.filter.unwrap_or(version::PAIR_FILTER)
    }

    /// The distance by which a renewed box extends beyond its collider.
    pub(crate) fn margin(&self, params: &IntegrationParameters) -> Real {
        let margin = self.settings.margin.unwrap_or(Self::DEFAULT_MARGIN);
        // A NaN counts as 0, also that of 0 · ∞.
        (margin.max(0.0) * params.length_unit.max(0.0)).max(0.0)
    }

    /// Updates as a part of a pipeline of a patched Rapier 0.36, which then asks for [`unreported`](Self::unreported) colliders.
    pub(crate) fn run_in_pipeline(
        &mut self,
        input: &Input<'_>,
        events: &mut Vec<BroadPhasePairEvent>,
    ) {
        let removed = input.lists.removed;
        self.table
            .find_unreported(input.felt, removed, &mut self.unreported);
        self.run(input, events);
    }

    /// Removes all colliders. Their pairs end without an event.
    #[allow(dead_code, reason = "only a patched Rapier 0.36 clears a broad phase")]
    pub(crate) fn remove_all(&mut self) {
        self.table.clear();
        self.query_tree = QueryTree::default();
    }

    /// Sets boxes, as a part of the next update.
    #[allow(dead_code, reason = "only Rapier 0.36 passes boxes")]
    pub(crate) fn set_boxes(
        &mut self,
        params: &IntegrationParameters,
        aabbs: &[(ColliderHandle, RapierAabb)],
    ) {
        if aabbs.is_empty() {
            return;
        }
        let extents = [self.margin(params), params.prediction_distance() / 2.0];
        parallel::enter(self.table.reading_section(aabbs.len()).work, || {
            let written = self.table.set_boxes(aabbs, extents);
            self.query_tree.note(written);
        });
    }

    /// Updates the boxes and the pairs, and appends the events.
    pub(crate) fn run(&mut self, input: &Input<'_>, events: &mut Vec<BroadPhasePairEvent>) {
        let margin = self.margin(input.params);
        let input = &Input {
            filter: Self::filter(&self.settings),
            ..*input
        };
        if input.lists.len() == 0 && !self.table.is_due(margin, input.reach()) {
            return;
        }
        let push = |is_added, [first, second]: [_; 2]| {
            let pair = ColliderPair::new(first, second);
            events.push(match is_added {
                true => BroadPhasePairEvent::AddPair(pair),
                false => BroadPhasePairEvent::DeletePair(pair),
            });
        };
        parallel::enter(self.table.work_ahead(&input.lists), || {
            let written = self.table.update(&input.lists, input, margin);
            self.query_tree.note(written);
            self.query_tree.grow_older();
            let (slack, changes) = (2.0 * margin, &mut self.changes);
            self.table
                .finish(input, slack, input.is_active, changes, push);
        });
    }
}
