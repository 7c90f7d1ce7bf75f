//! The broad phase as it is written and read by serde, in the midst of a simulation.
//!
//! What is written decides all events to come, in their order. Scratch memory, outlines of shapes and the tree for
//! queries are not: they are made anew when they are needed.

use serde::de::{Deserialize, Deserializer, Error};
use serde::ser::{Serialize, Serializer};

use super::broad_phase::UnisizeBroadPhase;
use super::outline::Outline;
use super::rapier::math::{DIM, Real};
use super::version::PairFilter;
use super::{Settings, Stats};
use crate::PhaseTimes;
use crate::pair_tracker::TrackerSnapshot;

/// The fields of a [`UnisizeBroadPhase`] that cannot be told from others.
#[derive(serde::Serialize, serde::Deserialize)]
struct Snapshot {
    settings: Settings,
    stats: Stats,
    has_warned: bool,
    generations: Vec<Option<u32>>,
    tracker: TrackerSnapshot<Real, DIM>,
    withheld: Vec<[u32; 2]>,
}

impl Snapshot {
    fn restore(self) -> Result<UnisizeBroadPhase, &'static str> {
        let mut restored = UnisizeBroadPhase::with_settings(self.settings);
        let tracker = self.tracker.restore(&mut restored.layers)?;
        restored.tracker.resume(tracker, self.stats.full_runs);
        if restored.tracker.slots() != self.generations.len() {
            return Err("there are not as many generations as slots");
        }
        let known = |&(slot, _): &(u32, _)| self.generations[slot as usize].is_some();
        if !restored.tracker.proxies().all(|proxy| known(&proxy)) {
            return Err("a box has no collider");
        }
        restored.filter = PairFilter::restore(self.withheld, restored.tracker.pairs())?;
        let proxies = restored.tracker.proxies().count();
        restored.stats = Stats {
            proxies,
            refused: self.generations.iter().flatten().count() - proxies,
            ..self.stats
        };
        restored.has_warned = self.has_warned;
        restored.outlines = vec![Outline::default(); self.generations.len()];
        restored.generations = self.generations;
        Ok(restored)
    }
}

/// What is written decides all events to come, and their order: a simulation that is restored, with all of
/// Rapier's sets, goes on as the one that was saved. For that the format must keep numbers bit for bit, as binary
/// formats do. It must be read by the version that has written it.
impl Serialize for UnisizeBroadPhase {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let snapshot = Snapshot {
            settings: self.settings,
            stats: Stats {
                times: PhaseTimes::default(),
                ..self.stats()
            },
            has_warned: self.has_warned,
            generations: self.generations.clone(),
            tracker: TrackerSnapshot::new(&self.tracker, &self.layers),
            withheld: self.filter.pairs(),
        };
        snapshot.serialize(serializer)
    }
}

/// Data of which no broad phase can have come is an error, and whatever is read without one is safe to use. To check it
/// takes about as long as a full search for pairs.
impl<'de> Deserialize<'de> for UnisizeBroadPhase {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let snapshot = Snapshot::deserialize(deserializer)?;
        snapshot.restore().map_err(D::Error::custom)
    }
}
