//! A table as serde writes and reads it. Of a memo about a collider, only the part is written that a volume depends on. The next reading makes
//! the rest again.

use serde::{Deserialize, Serialize};

use super::passing::Id;
use super::{Memo, ProxyTable};
use crate::aabb::Aabb;
use crate::pair_tracker::{FilterKey, TrackerSnapshot};
use crate::real::Real;
use crate::stats::Stats;

/// The part of a table that decides future events, and counts.
#[derive(Serialize, Deserialize)]
#[serde(bound(
    serialize = "R: Serialize, [R; D]: Serialize, M: Serialize, K: Serialize",
    deserialize = "R: Deserialize<'de>, [R; D]: Deserialize<'de>, M: Deserialize<'de>, K: Deserialize<'de>"
))]
pub(crate) struct TableSnapshot<R, const D: usize, M, K> {
    stats: Stats,
    /// Generations and memos by slot, up to the highest slot that ever had a known collider.
    colliders: Vec<(Option<u32>, M)>,
    is_begun: bool,
    pending: Vec<(Id, Option<Aabb<R, D>>)>,
    tracker: TrackerSnapshot<R, D, K>,
}

impl<R: Real, const D: usize, M: Memo, K: FilterKey> ProxyTable<R, D, M, K> {
    /// A snapshot between two updates.
    pub(crate) fn snapshot(&self) -> TableSnapshot<R, D, M, K> {
        let generations = self.generations[..self.known_slots].iter().copied();
        TableSnapshot {
            stats: self.stats,
            colliders: generations.zip(self.memos.iter().cloned()).collect(),
            is_begun: self.is_begun,
            pending: self.pending.clone().into_iter().collect(),
            tracker: self.tracker.snapshot(),
        }
    }

    /// The table that continues from a snapshot, or the first inconsistency. `volumes` says whether volumes are in use.
    pub(crate) fn restored(
        volumes: bool,
        snapshot: TableSnapshot<R, D, M, K>,
    ) -> Result<Self, &'static str> {
        let mut table = Self::new(volumes);
        table.tracker.restore(snapshot.tracker)?;
        let slots = table.tracker.proxies.len();
        table.known_slots = snapshot.colliders.len();
        if table.known_slots > slots {
            return Err("snapshot: there are more colliders than slots");
        }
        if table.known_slots > table.most_known_slots {
            return Err("snapshot: there are more colliders than a broad phase takes");
        }
        (table.generations, table.memos) = snapshot.colliders.into_iter().unzip();
        table.make_room(slots);
        table.known = table.generations.iter().flatten().count();
        table.pending = snapshot.pending.into_iter().collect();
        if !table.pending.values().flatten().all(Aabb::is_valid) {
            return Err("snapshot: a passed box is not valid");
        }
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
