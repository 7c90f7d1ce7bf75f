//! A table as serde writes and reads it.
//!
//! Memos about colliders are not written, because the next reading makes them again.

use serde::{Deserialize, Serialize};

use super::passing::Pending;
use super::{Memo, ProxyTable};
use crate::pair_tracker::{FilterKey, TrackerSnapshot};
use crate::real::Real;
use crate::stats::Stats;

/// The part of a table that decides future events, and counts.
#[derive(Serialize, Deserialize)]
#[serde(bound(
    serialize = "R: Serialize, [R; D]: Serialize, K: Serialize",
    deserialize = "R: Deserialize<'de>, [R; D]: Deserialize<'de>, K: Deserialize<'de>"
))]
pub(crate) struct TableSnapshot<R, const D: usize, K> {
    stats: Stats,
    /// Up to the highest slot that ever had a known collider.
    generations: Vec<Option<u32>>,
    is_begun: bool,
    pending: Pending,
    tracker: TrackerSnapshot<R, D, K>,
}

impl<R: Real, const D: usize, M: Memo, K: FilterKey> ProxyTable<R, D, M, K> {
    /// A snapshot between two updates.
    pub(crate) fn snapshot(&self) -> TableSnapshot<R, D, K> {
        TableSnapshot {
            stats: self.stats,
            generations: self.generations[..self.known_slots].to_vec(),
            is_begun: self.is_begun,
            pending: self.pending.clone(),
            tracker: self.tracker.snapshot(),
        }
    }

    /// The table that continues from a snapshot, or the first inconsistency. `volumes` says whether volumes are in use.
    pub(crate) fn restored(
        volumes: bool,
        snapshot: TableSnapshot<R, D, K>,
    ) -> Result<Self, &'static str> {
        let mut table = Self::new(volumes);
        table.tracker.restore(snapshot.tracker)?;
        let slots = table.tracker.proxies.len();
        table.generations = snapshot.generations;
        table.known_slots = table.generations.len();
        if table.known_slots > slots {
            return Err("snapshot: there are more generations than slots");
        }
        if table.known_slots > table.most_known_slots {
            return Err("snapshot: there are more colliders than a broad phase takes");
        }
        table.generations.resize(slots, None);
        table.memos.resize(slots, M::default());
        table.known = table.generations.iter().flatten().count();
        table.pending = snapshot.pending;
        table.is_begun = snapshot.is_begun;
        if !(table.is_begun || table.pending.is_empty() && table.touched().is_empty()) {
            return Err("snapshot: boxes were set for no update");
        }
        table.stats = snapshot.stats;
        let proxies = table.count_proxies();
        table.stats.proxies = proxies.ok_or("snapshot: a box has no collider")?;
        let has_collider = |slot: u32| table.generations[slot as usize].is_some();
        if !table.tracker.pairs().flatten().all(has_collider) {
            return Err("snapshot: a pair has no colliders");
        }
        Ok(table)
    }
}
