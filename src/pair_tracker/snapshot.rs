//! A tracker as it is written and read by serde.
//!
//! Pairs depend on boxes alone, but the order in which changes are reported depends on more: on fat boxes, on the order
//! of the candidates, on when there were full runs. All of that is written, so that a tracker that was read goes on as
//! the one that was written does. What can be derived from it is not written but made anew: which candidates are held,
//! lists, sorted layers. What is read is checked, so a tracker that was read is always consistent.

use serde::{Deserialize, Serialize};

use super::candidates::CandidatesSnapshot;
use super::layers::LayersSnapshot;
use super::{FilterKey, Foresight, PairTracker, Spent, absent, overlapping};
use crate::{Aabb, Kernel, Real};

/// What decides the changes to come.
#[derive(Serialize, Deserialize)]
#[serde(bound(
    serialize = "R: Serialize, K: Serialize",
    deserialize = "R: Real + Deserialize<'de>, K: Deserialize<'de>"
))]
pub(crate) struct TrackerSnapshot<R, const D: usize, K> {
    /// By slot.
    proxies: Vec<Option<Proxy<R, D, K>>>,
    foresight: Foresight,
    spent: Spent,
    full_runs: u64,
    candidates: CandidatesSnapshot,
    layers: LayersSnapshot<R, D>,
}

/// A box, its fat box and its filter key.
#[derive(Serialize, Deserialize)]
#[serde(bound(
    serialize = "R: Serialize, K: Serialize",
    deserialize = "R: Real + Deserialize<'de>, K: Deserialize<'de>"
))]
struct Proxy<R, const D: usize, K> {
    aabb: Aabb<R, D>,
    fat: Aabb<R, D>,
    key: K,
}

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// A tracker between two updates.
    pub(crate) fn snapshot(&self) -> TrackerSnapshot<R, D, K> {
        debug_assert!(!self.is_touched(), "an update was not finished");
        let proxies = self.boxes.iter().zip(&self.fat_boxes).zip(&self.keys);
        let proxy = |((&aabb, &fat), &key): ((&Aabb<R, D>, _), _)| {
            aabb.is_valid().then_some(Proxy { aabb, fat, key })
        };
        TrackerSnapshot {
            proxies: proxies.map(proxy).collect(),
            foresight: self.foresight,
            spent: self.spent,
            full_runs: self.full_runs,
            candidates: self.candidates.snapshot(),
            layers: self.layers.snapshot(self.boxes.len()),
        }
    }

    /// Goes on from where another tracker was; this one must be new.
    ///
    /// # Errors
    /// What is wrong, if no tracker can have written it.
    pub(crate) fn restore(
        &mut self,
        snapshot: TrackerSnapshot<R, D, K>,
    ) -> Result<(), &'static str> {
        let TrackerSnapshot {
            proxies,
            foresight,
            spent,
            full_runs,
            candidates,
            layers,
        } = snapshot;
        if u32::try_from(proxies.len()).is_err() {
            return Err("snapshot: there are more slots than 32-bit indices");
        }
        for proxy in proxies {
            let [aabb, fat] = match &proxy {
                None => [absent(); 2],
                Some(Proxy { aabb, .. }) if !aabb.is_valid() => {
                    return Err("snapshot: a box is not valid");
                }
                Some(Proxy { aabb, fat, .. }) if !fat.contains(aabb) => {
                    return Err("snapshot: a box is not in its fat box");
                }
                Some(Proxy { aabb, fat, .. }) => [*aabb, *fat],
            };
            self.boxes.push(aabb);
            self.fat_boxes.push(fat);
            self.keys
                .push(proxy.map_or(K::default(), |proxy| proxy.key));
        }
        self.previous.clone_from(&self.boxes);
        self.escaped.make_room(self.boxes.len());
        if foresight.is_fixed() != self.foresight.is_fixed() || !foresight.is_sound() {
            return Err("snapshot: the foresight is out of range (0 to 64 moves)");
        }
        self.foresight = foresight;
        self.spent = spent;
        self.full_runs = full_runs;
        self.are_filtered = self.keys.iter().any(|&key| key != K::default());
        let found = overlapping(Kernel::GridSweep, &self.fat_boxes, &self.keys);
        self.candidates = candidates.restore(&self.boxes, found)?;
        self.layers.restore(layers, &self.fat_boxes)
    }
}
