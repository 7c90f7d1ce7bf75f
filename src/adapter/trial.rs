//! Both broad phases at once, for who wants to know before the exchange.

mod ledger;
mod report;

pub use report::{Difference, Measured, TrialReport};

use super::Settings;
use super::broad_phase::UnisizeBroadPhase;
use super::collider_key::ColliderKey;
use super::rapier::dynamics::RigidBodySet;
use super::rapier::geometry::{
    BroadPhasePairEvent, ColliderHandle, ColliderSet, DefaultBroadPhase,
};
use super::version;
use crate::pair_filter::PairFilter;
use crate::pair_tracker::FilterKey;
use crate::stopwatch;
use ledger::{Ledger, Side};
use report::Cost;

/// The levels of the filter, from the one that leaves out nothing.
const LEVELS: [PairFilter; 4] = [
    PairFilter::Off,
    PairFilter::Bodies,
    PairFilter::Groups,
    PairFilter::Shapes,
];

/// Rapier's own broad phase, which drives the world as before, and unisize beside it, which is given the same: whether the two hold the
/// same pairs, and what either takes, in a scene of your own, before anything is exchanged.
///
/// Put it in the place of the broad phase, let the program run, and print its [`report`](Self::report):
///
/// ```text
/// let mut broad_phase = Trial::new();                                // Rapier 0.27
/// world.broad_phase = DefaultBroadPhase::custom(Trial::new());       // Rapier 0.36, opened
/// println!("{}", broad_phase.report());                              // some hundred steps later
/// ```
///
/// The simulation is the same to the last bit, only slower: unisize runs once for each [level of the filter](PairFilter), so an
/// update takes about as long as three of Rapier's own. All of them share the caches of the processor, so each is a little faster without
/// the others. After each update the pairs of unisize at the level of Rapier's own broad phase are compared with Rapier's own in
/// **O(events)**.
#[derive(Clone)]
pub struct Trial {
    pub(crate) own: DefaultBroadPhase,
    own_cost: Cost,
    pub(crate) tried: [UnisizeBroadPhase; 4],
    costs: [Cost; 4],
    updates: u64,
    /// Whether boxes were handed over since the last update.
    is_prepared: bool,
    ledger: Ledger,
    first_difference: Option<Difference>,
    /// See [`Self::with_allocated`].
    allocated: Option<fn() -> usize>,
    /// The colliders whose boxes were handed over last, where the trial looks on.
    #[allow(dead_code, reason = "in Rapier 0.27 it drives")]
    pub(crate) looked_at: Vec<ColliderHandle>,
}

/// What an update is about, besides the lists.
pub(crate) struct Updated<'a> {
    pub(crate) colliders: &'a ColliderSet,
    pub(crate) bodies: &'a RigidBodySet,
    pub(crate) removed: &'a [ColliderHandle],
    /// Whether there is anything to look at.
    pub(crate) is_busy: bool,
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
            costs: [Cost::default(); 4],
            updates: 0,
            is_prepared: false,
            ledger: Ledger::default(),
            first_difference: None,
            allocated: None,
            looked_at: Vec::new(),
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
        let levels = LEVELS.into_iter().zip(&self.costs);
        TrialReport {
            updates: self.updates,
            colliders: self.tried[0].stats().proxies,
            own: self.own_cost.measured(None),
            levels: levels
                .map(|(level, cost)| cost.measured(Some(level)))
                .collect(),
            default_level: version::PAIR_FILTER,
            compared_level: version::FILTER_OF_OWN,
            first_difference: self.first_difference,
        }
    }

    /// Runs something on Rapier's own broad phase, and something on each of unisize, clocked, as a part of the next update.
    #[allow(dead_code, reason = "only Rapier 0.36 hands boxes over")]
    pub(crate) fn prepare(
        &mut self,
        own: impl FnOnce(&mut DefaultBroadPhase),
        mut tried: impl FnMut(&mut UnisizeBroadPhase),
    ) {
        let allocated = self.allocated;
        self.is_prepared = true;
        self.own_cost.of(allocated, || own(&mut self.own));
        for (broad_phase, cost) in self.tried.iter_mut().zip(&mut self.costs) {
            cost.of(allocated, || tried(broad_phase));
        }
    }

    /// Runs an update on all of them, and compares. The events are those of Rapier's own.
    pub(crate) fn run(
        &mut self,
        updated: &Updated<'_>,
        events: &mut Vec<BroadPhasePairEvent>,
        own: impl FnOnce(&mut DefaultBroadPhase, &mut Vec<BroadPhasePairEvent>),
        mut tried: impl FnMut(&mut UnisizeBroadPhase, &mut Vec<BroadPhasePairEvent>),
    ) {
        let allocated = self.allocated;
        let is_busy = updated.is_busy | std::mem::take(&mut self.is_prepared);
        self.updates += u64::from(is_busy);
        self.ledger.forget(updated.removed);
        let earlier = events.len();
        self.own_cost
            .of(allocated, || own(&mut self.own, &mut *events));
        self.ledger.note(Side::Own, &events[earlier..]);
        self.own_cost.end_update(is_busy, self.ledger.held_by_own());

        for (i, level) in LEVELS.into_iter().enumerate() {
            let mut events = Vec::new();
            let broad_phase = &mut self.tried[i];
            self.costs[i].of(allocated, || tried(broad_phase, &mut events));
            self.costs[i].end_update(is_busy, broad_phase.stats().pairs);
            if level == version::FILTER_OF_OWN {
                self.ledger.note(Side::Unisize, &events);
            }
        }
        if self.first_difference.is_none() {
            self.first_difference = self.difference(updated);
        }
    }

    /// A pair that only one of the two holds, although the narrow phase would not drop it.
    fn difference(&self, updated: &Updated<'_>) -> Option<Difference> {
        let Updated {
            colliders, bodies, ..
        } = updated;
        let key = |handle| {
            let collider = colliders.get(handle)?;
            let body = collider.parent().and_then(|body| bodies.get(body));
            Some(ColliderKey::new(PairFilter::Groups, collider, body))
        };
        let differing = self.ledger.held_by_one().filter(|(pair, _)| {
            let keys = pair.map(key);
            matches!(keys, [Some(first), Some(second)] if first.may_meet(second))
        });
        // The least, so that it is always the same one.
        let (pair, holder) = differing.min_by_key(|(pair, _)| pair.map(|h| h.into_raw_parts()))?;
        Some(Difference {
            update: self.updates,
            colliders: pair,
            is_missing: holder == Side::Own,
        })
    }
}

impl std::fmt::Debug for Trial {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Trial")
            .field("report", &self.report())
            .finish_non_exhaustive()
    }
}

impl Cost {
    /// Runs something that belongs to the current update.
    fn of(&mut self, allocated: Option<fn() -> usize>, run: impl FnOnce()) {
        let bytes = allocated.map(|bytes| bytes());
        let began = stopwatch::now();
        run();
        if let Some(began) = began {
            self.current += began.elapsed();
        }
        if let (Some(before), Some(allocated)) = (bytes, allocated) {
            let bytes = self.bytes.get_or_insert(0);
            *bytes += allocated() as i64 - before as i64;
        }
    }
}
