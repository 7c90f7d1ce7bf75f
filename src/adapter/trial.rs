//! A trial of unisize next to Rapier's own broad phase, in a program of the user's.

mod report;

use report::LEVELS;
pub use report::{Difference, Measured, TrialReport};

use std::collections::{BTreeSet, HashMap, HashSet};

use super::collider_box::body_of;
use super::collider_key::ColliderKey;
use super::rapier::dynamics::RigidBodySet;
// In Rapier 0.27, this imports the trait with the method `update`.
use super::rapier::geometry::*;
use super::{Input, Settings, UnisizeBroadPhase, version};
use crate::pair_filter::PairFilter;
use crate::pair_tracker::FilterKey;
use crate::stats::Stats;

/// A broad phase that compares unisize with Rapier's own in your program, before you replace anything.
///
/// Rapier's own broad phase drives the world as before. unisize receives the same input, once for each [level of the filter](PairFilter). The
/// [`report`](Self::report) says how long each of them takes, how many pairs each holds, and whether the pairs match:
///
/// ```text
/// let mut broad_phase = Trial::new();                                // Rapier 0.27
/// world.broad_phase = DefaultBroadPhase::custom(Trial::new());       // Rapier 0.36, patched
/// println!("{}", broad_phase.report());                              // some hundred steps later
/// ```
///
/// The simulation is the same, only slower. What whole steps gain is more than the time of updates, because each level leaves other pairs to
/// the narrow phase; so run the program once on each broad phase, as the guide shows. On a patched Rapier 0.36, Rapier's own broad phase
/// optimizes its tree later in a step than it would alone, so the order of pairs and the last bits of poses may differ in large worlds. The
/// five broad phases compete for the caches of the processor, so each alone is a little faster than reported.
///
/// # Complexity
///
/// An update runs all five broad phases. It then compares the pairs of Rapier's own broad phase with those of unisize at the same level of the
/// filter, in **O(pairs)** time.
///
/// # Errors
///
/// No input makes a trial panic unless Rapier's own broad phase panics. Pairs that differ are not an error:
/// [`TrialReport::first_difference`] names the first one.
#[derive(Clone)]
pub struct Trial {
    pub(crate) own: DefaultBroadPhase,
    own_pairs: HeldPairs,
    /// unisize at each of the [`LEVELS`].
    pub(crate) tried: [UnisizeBroadPhase; LEVELS.len()],
    /// The pairs of unisize at the level of Rapier's own broad phase.
    pairs: HeldPairs,
    /// Of Rapier's own broad phase, and of unisize at each level.
    pub(crate) own_measured: Measured,
    pub(crate) measured: [Measured; LEVELS.len()],
    first_difference: Option<Difference>,
    /// See [`with_allocated`](Self::with_allocated).
    pub(crate) allocated: Option<fn() -> usize>,
    /// The colliders of the last call of `observe`.
    #[allow(dead_code, reason = "only Rapier 0.36 has Trial::observe")]
    pub(crate) observed: HashMap<ColliderHandle, ColliderKey>,
}

impl Default for Trial {
    fn default() -> Self {
        Self::with_settings(Settings::default())
    }
}

impl Trial {
    /// Creates a trial without colliders, with default settings for unisize.
    pub fn new() -> Self {
        Self::default()
    }

    /// Creates a trial without colliders. The trial overrides the level of the filter in the settings. With a
    /// [margin](crate::Settings::margin) other than that of Rapier's own broad phase, the pairs differ, and the report says so.
    pub fn with_settings(settings: Settings) -> Self {
        Self {
            own: DefaultBroadPhase::new(),
            own_pairs: HeldPairs::default(),
            tried: LEVELS
                .map(|level| UnisizeBroadPhase::with_settings(settings.with_filter(level))),
            pairs: HeldPairs::default(),
            own_measured: Measured::default(),
            measured: LEVELS.map(Measured::of),
            first_difference: None,
            allocated: None,
            observed: HashMap::new(),
        }
    }

    /// Returns the trial with memory in its report. `allocated` returns the number of bytes that the program has allocated, as a counting global
    /// allocator knows it.
    pub fn with_allocated(self, allocated: fn() -> usize) -> Self {
        Self {
            allocated: Some(allocated),
            ..self
        }
    }

    /// Returns Rapier's own broad phase, for queries.
    pub fn own(&self) -> &DefaultBroadPhase {
        &self.own
    }

    /// Returns the results so far. Computes in **O(1)** time.
    pub fn report(&self) -> TrialReport {
        TrialReport {
            updates: self.stats().updates,
            colliders: self.stats().proxies,
            own: self.own_measured,
            levels: self.measured,
            first_difference: self.first_difference,
        }
    }

    /// What decides which others a collider may meet, at any level of the filter.
    pub(crate) fn key(collider: &Collider, bodies: &RigidBodySet) -> ColliderKey {
        ColliderKey::new(PairFilter::Groups, collider, body_of(collider, bodies))
    }

    /// The counts at level `Shapes`.
    pub(crate) fn stats(&self) -> Stats {
        self.tried[PairFilter::Shapes as usize].stats()
    }

    /// Removes all colliders.
    #[allow(dead_code, reason = "only a patched Rapier 0.36 clears a broad phase")]
    pub(crate) fn remove_all(&mut self) {
        self.own = DefaultBroadPhase::new();
        (self.own_pairs, self.pairs) = Default::default();
        let tried = self.tried.iter_mut();
        tried.for_each(UnisizeBroadPhase::remove_all);
    }

    /// Updates all broad phases, and compares their pairs. The events are those of Rapier's own.
    pub(crate) fn run(&mut self, input: &Input<'_>, events: &mut Vec<BroadPhasePairEvent>) {
        let (params, colliders, bodies) = (input.params, input.colliders, input.bodies);
        let (modified, removed) = (input.lists.modified, input.lists.removed);
        let (former, allocated, earlier) = (self.stats().updates, self.allocated, events.len());
        self.own_measured.run(allocated, events, |events| {
            self.own
                .update(params, colliders, bodies, modified, removed, events);
        });
        self.own_pairs.update(removed, &events[earlier..]);
        let tried = self.tried.iter_mut().zip(&mut self.measured);
        for (level, (broad_phase, measured)) in LEVELS.into_iter().zip(tried) {
            let mut events = Vec::new();
            measured.run(allocated, &mut events, |events| match input.is_active {
                Some(_) => broad_phase.run_in_pipeline(input, events),
                None => broad_phase.run(input, events),
            });
            if level == version::FILTER_OF_OWN {
                self.pairs.update(removed, &events);
            }
        }
        let update = Some(self.stats().updates).filter(|&update| update > former);
        self.own_measured.end_update(update, self.own_pairs.0.len());
        for (broad_phase, measured) in self.tried.iter().zip(&mut self.measured) {
            measured.end_update(update, broad_phase.stats().pairs);
        }
        if self.first_difference.is_none() {
            self.first_difference = self.difference(input);
        }
    }

    /// The first pair that only one of the two broad phases holds and that the narrow phase would not drop.
    fn difference(&self, input: &Input<'_>) -> Option<Difference> {
        let HeldPairs(own) = &self.own_pairs;
        let mut differing = own.symmetric_difference(&self.pairs.0);
        let handles = |pair: [(u32, u32); 2]| {
            pair.map(|(index, generation)| ColliderHandle::from_raw_parts(index, generation))
        };
        let pair = differing.find(|&&pair| {
            let colliders = handles(pair).map(|handle| input.colliders.get(handle));
            let keys = colliders.map(|collider| Some(Self::key(collider?, input.bodies)));
            matches!(keys, [Some(first), Some(second)] if first.may_meet(second))
        })?;
        Some(Difference {
            update: self.stats().updates,
            colliders: handles(*pair),
            is_missing: own.contains(pair),
        })
    }
}

/// The pairs of a broad phase, collected from its events: index and generation of two colliders, in order.
#[derive(Clone, Default)]
struct HeldPairs(BTreeSet<[(u32, u32); 2]>);

impl HeldPairs {
    /// Ends the pairs of removed colliders, which have no events, and applies events. Rapier's own broad phase may add a pair twice.
    fn update(&mut self, removed: &[ColliderHandle], events: &[BroadPhasePairEvent]) {
        let removed: HashSet<_> = removed.iter().map(|it| it.into_raw_parts()).collect();
        self.0
            .retain(|pair| pair.iter().all(|collider| !removed.contains(collider)));
        let raw = |pair: &ColliderPair| {
            let mut pair = [pair.collider1, pair.collider2].map(|handle| handle.into_raw_parts());
            pair.sort_unstable();
            pair
        };
        for event in events {
            match event {
                BroadPhasePairEvent::AddPair(pair) => self.0.insert(raw(pair)),
                BroadPhasePairEvent::DeletePair(pair) => self.0.remove(&raw(pair)),
            };
        }
    }
}

impl std::fmt::Debug for Trial {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Trial")
            .field("report", &self.report())
            .finish_non_exhaustive()
    }
}
