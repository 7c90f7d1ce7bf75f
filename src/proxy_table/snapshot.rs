//! A table as serde writes and reads it.
//!
//! Memos about colliders are not written, because the next reading makes them again.

use serde::{Deserialize, Serialize};

use super::passing::Pending;
use super::{Gathered, ProxyTable};
use crate::pair_tracker::{FilterKey, TrackerSnapshot};
use crate::real::Real;
use crate::settings::Settings;
use crate::stats::Stats;
use crate::stopwatch::PhaseTimes;

/// The part of a table that decides future events, and counts.
#[derive(Serialize, Deserialize)]
#[serde(bound(
    serialize = "R: Serialize, [R; D]: Serialize, K: Serialize",
    deserialize = "R: Deserialize<'de>, [R; D]: Deserialize<'de>, K: Deserialize<'de>"
))]
pub(crate) struct TableSnapshot<R, const D: usize, K> {
    stats: Stats,
    has_warned: bool,
    /// Up to the highest slot that ever had a known collider.
    generations: Vec<Option<u32>>,
    gathered: Gathered,
    pending: Pending,
    tracker: TrackerSnapshot<R, D, K>,
}

impl<R: Real, const D: usize, M: Clone + Default + Send + Sync, K: FilterKey>
    ProxyTable<R, D, M, K>
{
    /// A snapshot between two updates.
    pub(crate) fn snapshot(&self) -> TableSnapshot<R, D, K> {
        TableSnapshot {
            // Counts of the last update; reading counts the proxies again.
            stats: Stats {
                times: PhaseTimes::default(),
                refused: self.refused(),
                ..self.stats
            },
            has_warned: self.has_warned,
            generations: self.generations[..self.known_slots].to_vec(),
            gathered: self.gathered,
            pending: self.pending.clone(),
            tracker: self.tracker.snapshot(),
        }
    }

    /// The table that continues from a snapshot, with the settings that it had.
    ///
    /// # Errors
    /// A description of the first inconsistency, if no table can have written the snapshot.
    pub(crate) fn restored(
        settings: &Settings<R>,
        snapshot: TableSnapshot<R, D, K>,
    ) -> Result<Self, &'static str> {
        let mut table = Self::new(settings);
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
        table.gathered = snapshot.gathered;
        let Gathered {
            is_begun,
            listed,
            moved,
        } = table.gathered;
        if !(is_begun || table.pending.is_empty() && table.touched().is_empty()) {
            return Err("snapshot: boxes were set for no update");
        }
        // Later additions must not overflow a word of 32 bits.
        if listed.max(moved) > (u32::MAX / 2) as usize {
            return Err("snapshot: more boxes were set than can be counted");
        }
        table.has_warned = snapshot.has_warned;
        table.stats = Stats {
            times: PhaseTimes::default(),
            ..snapshot.stats
        };
        let proxies = table.count_proxies();
        table.stats.proxies = proxies.ok_or("snapshot: a box has no collider")?;
        let has_collider = |slot: u32| table.generations[slot as usize].is_some();
        if !table.tracker.pairs().flatten().all(has_collider) {
            return Err("snapshot: a pair has no colliders");
        }
        Ok(table)
    }
}
