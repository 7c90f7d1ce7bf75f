//! A table as it is written and read by serde.
//!
//! What the engine wants remembered of its colliders is not written: it is learned anew.

use serde::{Deserialize, Serialize};

use super::handing_over::HandedOver;
use super::{Gathered, ProxyTable};
use crate::pair_tracker::{FilterKey, TrackerSnapshot};
use crate::slot_set::SlotSet;
use crate::{PhaseTimes, Real, Settings, Stats};

/// What decides the events to come.
#[derive(Serialize, Deserialize)]
#[serde(bound(
    serialize = "R: Serialize, K: Serialize",
    deserialize = "R: Real + Deserialize<'de>, K: Deserialize<'de>"
))]
pub(crate) struct TableSnapshot<R, const D: usize, K> {
    stats: Stats,
    has_warned: bool,
    /// Up to the highest slot that ever had a known collider.
    generations: Vec<Option<u32>>,
    /// What was handed over since the last update.
    gathered: Gathered,
    /// Slot, generation and boxes of each.
    awaited: Vec<(u32, u32, Option<HandedOver<R, D>>)>,
    tracker: TrackerSnapshot<R, D, K>,
}

impl<R: Real, const D: usize, M: Clone + Default + Send, K: FilterKey> ProxyTable<R, D, M, K> {
    /// A table between two updates.
    pub(crate) fn snapshot(&self) -> TableSnapshot<R, D, K> {
        TableSnapshot {
            // Of the last update; what is held is counted again.
            stats: Stats {
                times: PhaseTimes::default(),
                ..self.stats
            },
            has_warned: self.has_warned,
            generations: self.generations[..self.known_slots].to_vec(),
            gathered: self.gathered,
            awaited: self
                .awaited
                .iter()
                .map(|(&(slot, generation), &boxes)| (slot, generation, boxes))
                .collect(),
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
            mut generations,
            gathered,
            awaited,
            tracker,
        } = snapshot;
        let mut table = Self::new(settings);
        table.tracker.restore(tracker)?;
        let known_slots = generations.len();
        if known_slots > table.tracker.slots() {
            return Err("snapshot: there are more generations than slots");
        }
        generations.resize(table.tracker.slots(), None);
        let is_touched = !(awaited.is_empty() && table.tracker.touched().is_empty());
        if is_touched && !gathered.is_begun {
            return Err("snapshot: boxes were handed over for no update");
        }
        if gathered.listed.max(gathered.moved) > u32::MAX as usize {
            return Err("snapshot: more boxes were handed over than can be counted");
        }
        let mut is_awaited = SlotSet::default();
        is_awaited.make_room(generations.len());
        for &(slot, ..) in &awaited {
            if (slot as usize) < generations.len() {
                is_awaited.insert(slot);
            }
        }
        let mut proxies = 0;
        for (slot, _) in table.tracker.proxies() {
            let is_known = generations[slot as usize].is_some();
            if !is_known && !is_awaited.contains(slot) {
                return Err("snapshot: a box has no collider");
            }
            proxies += usize::from(is_known);
        }
        let is_known = |pair: [u32; 2]| {
            pair.iter()
                .all(|&slot| generations[slot as usize].is_some())
        };
        if !table.tracker.pairs().all(is_known) {
            return Err("snapshot: a pair has no colliders");
        }
        table.stats = Stats {
            proxies,
            refused: generations.iter().flatten().count() - proxies,
            ..stats
        };
        table.has_warned = has_warned;
        table.memos.resize(generations.len(), M::default());
        table.generations = generations;
        table.known_slots = known_slots;
        table.gathered = gathered;
        table.awaited = awaited
            .into_iter()
            .map(|(slot, generation, boxes)| ((slot, generation), boxes))
            .collect();
        Ok(table)
    }
}
