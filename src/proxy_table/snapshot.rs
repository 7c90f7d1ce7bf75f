//! A table as it is written and read by serde.
//!
//! What the engine wants remembered of its colliders is not written: it is learned anew.

use serde::{Deserialize, Serialize};

use super::ProxyTable;
use crate::pair_tracker::{FilterKey, TrackerSnapshot};
use crate::{Aabb, PhaseTimes, Real, Settings, Stats};

/// What decides the events to come.
#[derive(Serialize, Deserialize)]
#[serde(bound(
    serialize = "R: Serialize, K: Serialize",
    deserialize = "R: Real + Deserialize<'de>, K: Deserialize<'de>"
))]
pub(crate) struct TableSnapshot<R, const D: usize, K> {
    stats: Stats,
    has_warned: bool,
    generations: Vec<Option<u32>>,
    tracker: TrackerSnapshot<R, D, K>,
}

impl<R: Real, const D: usize, M: Clone + Default + Send, K: FilterKey> ProxyTable<R, D, M, K> {
    /// A table between two updates.
    pub(crate) fn snapshot(&self) -> TableSnapshot<R, D, K> {
        TableSnapshot {
            stats: Stats {
                times: PhaseTimes::default(),
                ..self.stats()
            },
            has_warned: self.has_warned,
            generations: self.generations.clone(),
            tracker: self.tracker.snapshot(),
        }
    }

    /// The table that goes on from there, with the settings that it had.
    ///
    /// # Errors
    /// What is wrong, if no table can have written it.
    pub(crate) fn restored(
        settings: &Settings<R>,
        snapshot: TableSnapshot<R, D, K>,
    ) -> Result<Self, &'static str> {
        let TableSnapshot {
            stats,
            has_warned,
            generations,
            tracker,
        } = snapshot;
        let mut table = Self::new(settings);
        table.tracker.restore(tracker)?;
        if table.tracker.slots() != generations.len() {
            return Err("snapshot: the generations are not as many as the slots");
        }
        let is_known = |(slot, _): (u32, &Aabb<R, D>)| generations[slot as usize].is_some();
        if !table.tracker.proxies().all(is_known) {
            return Err("snapshot: a box has no collider");
        }
        let proxies = table.tracker.proxies().count();
        table.stats = Stats {
            proxies,
            refused: generations.iter().flatten().count() - proxies,
            ..stats
        };
        table.tracker.work = stats.work;
        table.has_warned = has_warned;
        table.memos.resize(generations.len(), M::default());
        table.generations = generations;
        Ok(table)
    }
}
