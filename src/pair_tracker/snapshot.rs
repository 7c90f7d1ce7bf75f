//! A tracker as it is written and read by serde.
//!
//! The changes to come, and their order in events, depend on boxes, filter keys and volumes, and on which pairs whose boxes overlap are
//! held. Only that is written. Fat boxes, candidates, layers and the foresight decide how much work it is to find the changes; a tracker
//! that was read makes them anew. Between two updates boxes may have been handed over, so what has been touched since the last update is
//! written too. What is read is checked, so a tracker that was read is always consistent.

use serde::{Deserialize, Serialize};

use super::candidates::Candidates;
use super::volumes::VolumesSnapshot;
use super::{FilterKey, PairTracker, overlapping};
use crate::slot_set::SlotSet;
use crate::{Aabb, Kernel, Real};

/// What decides the changes to come.
#[derive(Serialize, Deserialize)]
#[serde(bound(
    serialize = "R: Serialize, K: Serialize",
    deserialize = "R: Real + Deserialize<'de>, K: Deserialize<'de>"
))]
pub(crate) struct TrackerSnapshot<R, const D: usize, K> {
    /// By slot, as of the last `finish`.
    proxies: Vec<Option<Proxy<R, D, K>>>,
    /// The keys of slots without a proxy, except default ones: a box that is handed over does not bring its key.
    other_keys: Vec<(u32, K)>,
    /// The slots touched since the last `finish`, with their present boxes.
    touched: Vec<(u32, Option<Aabb<R, D>>)>,
    volumes: VolumesSnapshot<R>,
    /// The slots whose volumes have changed since the last `finish`.
    stirred: Vec<u32>,
    /// The pairs whose boxes overlap and that are not held, by their volumes alone.
    near: Vec<[u32; 2]>,
    full_runs: u64,
}

/// A box and its filter key.
#[derive(Serialize, Deserialize)]
#[serde(bound(
    serialize = "R: Serialize, K: Serialize",
    deserialize = "R: Real + Deserialize<'de>, K: Deserialize<'de>"
))]
struct Proxy<R, const D: usize, K> {
    aabb: Aabb<R, D>,
    key: K,
}

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// A tracker between two updates.
    pub(crate) fn snapshot(&self) -> TrackerSnapshot<R, D, K> {
        debug_assert!(self.former_keys.is_empty(), "an update has begun");
        let proxies = self.previous.iter().zip(&self.keys);
        let proxy =
            |(&aabb, &key): (&Aabb<R, D>, _)| aabb.is_valid().then_some(Proxy { aabb, key });
        let mut near: Vec<_> = self.candidates.near().collect();
        near.sort_unstable();
        let other_keys = (0..).zip(self.previous.iter().zip(&self.keys));
        let other_keys = other_keys
            .filter(|(_, (before, key))| !before.is_valid() && **key != K::default())
            .map(|(slot, (_, &key))| (slot, key));
        let touched = self
            .touched
            .iter()
            .map(|&slot| (slot, self.get(slot).copied()));
        TrackerSnapshot {
            proxies: proxies.map(proxy).collect(),
            other_keys: other_keys.collect(),
            touched: touched.collect(),
            volumes: self.volumes.snapshot(),
            stirred: self.stirred.clone(),
            near,
            full_runs: self.full_runs,
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
            other_keys,
            touched,
            volumes,
            stirred,
            near,
            full_runs,
        } = snapshot;
        if u32::try_from(proxies.len()).is_err() {
            return Err("snapshot: there are more slots than 32-bit indices");
        }
        for proxy in proxies {
            let aabb = proxy.as_ref().map(|proxy| proxy.aabb);
            if aabb.is_some_and(|aabb| !aabb.is_valid()) {
                return Err("snapshot: a box is not valid");
            }
            self.previous.push(aabb.unwrap_or(Aabb::ABSENT));
            self.keys
                .push(proxy.map_or(K::default(), |proxy| proxy.key));
        }
        // Each fat box is its box, so what moves is searched for at once.
        self.fat_boxes.clone_from(&self.previous);
        for (slot, key) in other_keys {
            match (
                self.keys.get_mut(slot as usize),
                self.previous.get(slot as usize),
            ) {
                (Some(known), Some(before)) if !before.is_valid() => *known = key,
                _ => {
                    return Err(
                        "snapshot: a spare filter key names a slot that is out of range or has a proxy",
                    );
                }
            }
        }
        self.full_runs = full_runs;
        self.are_filtered = self.keys.iter().any(|&key| key != K::default());
        let found = overlapping(Kernel::GridSweep, &self.fat_boxes, &self.keys);
        self.volumes.restore(volumes, self.previous.len())?;
        self.candidates = Candidates::restored(found, near)?;
        self.restore_touched(touched)?;
        self.restore_stirred(stirred)
    }

    /// Stirs slots again, as they were stirred since the last `finish`.
    fn restore_stirred(&mut self, stirred: Vec<u32>) -> Result<(), &'static str> {
        let slots = self.boxes.len();
        if stirred.iter().any(|&slot| slot as usize >= slots) {
            return Err("snapshot: a volume has changed whose slot is out of range");
        }
        if !(stirred.is_empty() || self.volumes.are_used()) {
            return Err("snapshot: a volume has changed where none is in use");
        }
        self.stirred = stirred;
        let mut are_pending = SlotSet::default();
        are_pending.make_room(slots);
        let pending = self.touched.iter().chain(&self.stirred);
        pending.for_each(|&slot| are_pending.insert(slot));
        let is_pending = |pair: [u32; 2]| pair.iter().any(|&slot| are_pending.contains(slot));
        let mut near = self.candidates.near();
        match near.all(|pair| is_pending(pair) || !self.volumes.meet(pair, R::ZERO)) {
            true => Ok(()),
            false => Err("snapshot: a pair is not held although its volumes meet"),
        }
    }

    /// Touches slots again, as they were touched since the last `finish`.
    fn restore_touched(
        &mut self,
        touched: Vec<(u32, Option<Aabb<R, D>>)>,
    ) -> Result<(), &'static str> {
        self.boxes.clone_from(&self.previous);
        self.escaped.make_room(self.boxes.len());
        for (slot, aabb) in touched {
            let held = self.boxes.get_mut(slot as usize);
            *held.ok_or("snapshot: a touched slot is out of range")? = aabb.unwrap_or(Aabb::ABSENT);
            if aabb.is_some_and(|aabb| !aabb.is_valid()) {
                return Err("snapshot: a box that was handed over is not valid");
            }
            self.touched.push(slot);
        }
        for &slot in &self.touched {
            let [aabb, fat] = [&self.boxes, &self.fat_boxes].map(|boxes| &boxes[slot as usize]);
            if !fat.contains(aabb) {
                self.escaped.insert(slot);
            }
        }
        Ok(())
    }
}
