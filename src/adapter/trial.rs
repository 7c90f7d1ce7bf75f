//! Both broad phases at once, to find out what unisize gains in a scene before it is used.

mod cost;
mod report;
#[cfg(test)]
mod tests;

pub use report::{Difference, Measured, TrialReport};

use std::collections::{BTreeSet, HashMap, HashSet};
use std::time::Duration;

use super::Settings;
use super::broad_phase::{Input, UnisizeBroadPhase};
use super::collider_box::body_of;
use super::collider_key::ColliderKey;
use super::rapier::dynamics::RigidBodySet;
// With it comes the trait of which `update` is a method in Rapier 0.27.
use super::rapier::geometry::*;
use super::version;
use crate::pair_filter::PairFilter;
use crate::pair_tracker::FilterKey;
use crate::proxy_table::Lists;
use crate::stopwatch;
use cost::Cost;

/// The levels of the filter, from the one that leaves out nothing.
const LEVELS: [PairFilter; 4] = [
    PairFilter::Off,
    PairFilter::Bodies,
    PairFilter::Groups,
    PairFilter::Shapes,
];

/// Rapier's own broad phase, which drives the world as before, with unisize beside it, which is given the same input. It tells whether the
/// two hold the same pairs and what each takes, in a scene of your own, before you replace anything.
///
/// Use it as the broad phase, let the program run, and print its [`report`](Self::report):
///
/// ```text
/// let mut broad_phase = Trial::new();                                // Rapier 0.27
/// world.broad_phase = DefaultBroadPhase::custom(Trial::new());       // Rapier 0.36, patched
/// println!("{}", broad_phase.report());                              // some hundred steps later
/// ```
///
/// The simulation is the same to the last bit, only slower: unisize runs once for each [level of the filter](PairFilter), and what that
/// takes is in the report. All of them share the caches of the processor, so each is a little faster without the others. After each
/// update the pairs of unisize at the level of Rapier's own broad phase are compared with Rapier's own, in **O(pairs)**.
#[derive(Clone)]
pub struct Trial {
    pub(crate) own: DefaultBroadPhase,
    own_cost: Cost,
    pub(crate) tried: [UnisizeBroadPhase; LEVELS.len()],
    costs: [Cost; LEVELS.len()],
    updates: u64,
    /// Whether boxes were handed over since the last update.
    is_prepared: bool,
    /// What all has taken, the comparison included.
    total: Duration,
    /// What Rapier's own holds, and what unisize holds at the same level of the filter.
    own_pairs: HeldPairs,
    pairs: HeldPairs,
    first_difference: Option<Difference>,
    /// See [`Self::with_allocated`].
    allocated: Option<fn() -> usize>,
    /// The colliders whose boxes were handed over last, where the trial looks on.
    #[allow(dead_code, reason = "in Rapier 0.27 it drives")]
    pub(crate) looked_at: HashMap<ColliderHandle, ColliderKey>,
}

/// What decides whom a collider may meet, whatever the level of the filter.
pub(crate) fn key(collider: &Collider, bodies: &RigidBodySet) -> ColliderKey {
    ColliderKey::new(PairFilter::Groups, collider, body_of(collider, bodies))
}

impl Default for Trial {
    fn default() -> Self {
        Self::with_settings(Settings::default())
    }
}

impl Trial {
    /// Both without any colliders, unisize with default settings.
    pub fn new() -> Self {
        Self::default()
    }

    /// Both without any colliders. Each level of the filter is tried, whatever the settings say of it. With another
    /// [margin](crate::Settings::margin) than Rapier's own the pairs are not the same, and the report says so.
    pub fn with_settings(settings: Settings) -> Self {
        Self {
            own: DefaultBroadPhase::new(),
            own_cost: Cost::default(),
            tried: LEVELS
                .map(|level| UnisizeBroadPhase::with_settings(settings.with_filter(level))),
            costs: [Cost::default(); LEVELS.len()],
            updates: 0,
            is_prepared: false,
            total: Duration::ZERO,
            own_pairs: HeldPairs::default(),
            pairs: HeldPairs::default(),
            first_difference: None,
            allocated: None,
            looked_at: HashMap::new(),
        }
    }

    /// The same, with memory in the report: `allocated` tells how many bytes the program has allocated, as a counting global allocator
    /// knows.
    pub fn with_allocated(self, allocated: fn() -> usize) -> Self {
        Self {
            allocated: Some(allocated),
            ..self
        }
    }

    /// Rapier's own broad phase, for queries.
    pub fn own(&self) -> &DefaultBroadPhase {
        &self.own
    }

    /// What has been found out so far. **O(1)**.
    pub fn report(&self) -> TrialReport {
        let measured = |cost: &Cost, level| cost.measured(level, self.updates);
        let own = measured(&self.own_cost, None);
        TrialReport {
            updates: self.updates,
            colliders: self.tried[0].stats().proxies,
            overhead: self.total.saturating_sub(own.total),
            own,
            levels: std::array::from_fn(|i| measured(&self.costs[i], Some(LEVELS[i]))),
            default_level: version::PAIR_FILTER,
            compared_level: version::FILTER_OF_OWN,
            first_difference: self.first_difference,
        }
    }

    /// Runs something on Rapier's own broad phase, and something on each of unisize, as a part of the next update.
    #[allow(dead_code, reason = "only Rapier 0.36 hands boxes over")]
    pub(crate) fn prepare(
        &mut self,
        own: impl FnOnce(&mut DefaultBroadPhase),
        mut tried: impl FnMut(&mut UnisizeBroadPhase),
    ) {
        let began = stopwatch::now();
        self.is_prepared = true;
        let (allocated, no_events) = (self.allocated, &mut Vec::new());
        self.own_cost
            .of(allocated, no_events, |_| own(&mut self.own));
        for (broad_phase, cost) in self.tried.iter_mut().zip(&mut self.costs) {
            cost.of(allocated, no_events, |_| tried(broad_phase));
        }
        self.total += stopwatch::since(began);
    }

    /// Runs an update on all of them, and compares. The events are those of Rapier's own.
    pub(crate) fn run(&mut self, input: &Input<'_>, events: &mut Vec<BroadPhasePairEvent>) {
        let began = stopwatch::now();
        let Input {
            params,
            colliders,
            bodies,
            lists: Lists {
                modified, removed, ..
            },
            ..
        } = *input;
        let is_busy = std::mem::take(&mut self.is_prepared) || !input.lists.are_empty();
        self.updates += u64::from(is_busy);
        let update = is_busy.then_some(self.updates);
        let (allocated, earlier) = (self.allocated, events.len());
        self.own_cost.of(allocated, events, |events| {
            self.own
                .update(params, colliders, bodies, modified, removed, events);
        });
        self.own_pairs.update(removed, &events[earlier..]);
        self.own_cost.end_update(update, self.own_pairs.0.len());

        let tried = self.tried.iter_mut().zip(&mut self.costs);
        for (level, (broad_phase, cost)) in LEVELS.into_iter().zip(tried) {
            let mut events = Vec::new();
            cost.of(allocated, &mut events, |events| {
                broad_phase.update_in_pipeline(input, events);
            });
            cost.end_update(update, broad_phase.stats().pairs);
            if level == version::FILTER_OF_OWN {
                self.pairs.update(removed, &events);
            }
        }
        if self.first_difference.is_none() {
            self.first_difference = self.difference(input);
        }
        self.total += stopwatch::since(began);
    }

    /// The least pair that only one of the two holds, although the narrow phase would not drop it.
    fn difference(&self, input: &Input<'_>) -> Option<Difference> {
        let HeldPairs(own) = &self.own_pairs;
        let mut differing = own.symmetric_difference(&self.pairs.0);
        let handles = |pair: [(u32, u32); 2]| {
            pair.map(|(index, generation)| ColliderHandle::from_raw_parts(index, generation))
        };
        let pair = differing.find(|&&pair| {
            let colliders = handles(pair).map(|handle| input.colliders.get(handle));
            let keys = colliders.map(|collider| Some(key(collider?, input.bodies)));
            matches!(keys, [Some(first), Some(second)] if first.may_meet(second))
        })?;
        Some(Difference {
            update: self.updates,
            colliders: handles(*pair),
            is_missing: own.contains(pair),
        })
    }
}

/// The pairs that a broad phase holds, by its events: index and generation of two colliders, in order.
#[derive(Clone, Default)]
struct HeldPairs(BTreeSet<[(u32, u32); 2]>);

impl HeldPairs {
    /// Ends the pairs of what was removed, of which no event tells, and takes events. A pair may begin that is held already, as with
    /// Rapier's own.
    fn update(&mut self, removed: &[ColliderHandle], events: &[BroadPhasePairEvent]) {
        if !removed.is_empty() {
            let removed = removed.iter().map(|handle| handle.into_raw_parts());
            let removed: HashSet<_> = removed.collect();
            self.0
                .retain(|pair| pair.iter().all(|collider| !removed.contains(collider)));
        }
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
