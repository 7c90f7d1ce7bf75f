//! The serialized form of a tracker.
//!
//! Later changes, and the order of their events, depend on boxes, filter keys and volumes, and on which pairs of overlapping boxes are
//! held. These are serialized, with the acquainted slots and a count. Fat boxes, candidates, layers and the foresight decide how long it
//! takes to find the changes; a restored tracker makes them again. Boxes may be written between two updates, so the slots touched since the
//! last update are serialized too. Restoring checks everything, so a restored tracker is always consistent.

use serde::{Deserialize, Serialize};

use super::proxies::overlap;
use super::validation::overlapping;
use super::volumes::VolumesSnapshot;
use super::{FilterKey, PairState, PairTracker};
use crate::aabb::Aabb;
use crate::grid_sweep::{GridSweep, MAX_BOXES};
use crate::real::Real;
use crate::slot_set::SlotSet;

/// The state on which later changes depend.
#[derive(Serialize, Deserialize)]
#[serde(bound(
    serialize = "R: Serialize, [R; D]: Serialize, K: Serialize",
    deserialize = "R: Deserialize<'de>, [R; D]: Deserialize<'de>, K: Deserialize<'de>"
))]
pub(crate) struct TrackerSnapshot<R, const D: usize, K> {
    /// By slot, the boxes at the end of the last update.
    boxes: Vec<Option<Aabb<R, D>>>,
    /// By slot, also without a box: a box that is passed later comes without a key.
    keys: Vec<K>,
    /// The slots touched since the last update, with their present boxes.
    touched: Vec<(u32, Option<Aabb<R, D>>)>,
    volumes: VolumesSnapshot<R>,
    /// The slots whose volumes have changed since the last update.
    revolumed: Vec<u32>,
    /// The pairs whose boxes overlap and that are not held.
    near: Vec<[u32; 2]>,
    /// The pairs whose boxes overlap and that their keys have come to forbid, held or not.
    forbidden: Vec<[u32; 2]>,
    /// The acquainted slots, if volumes are in use.
    acquainted: Vec<u32>,
    full_searches: u64,
}

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// The serialized form of a tracker between two updates.
    pub(crate) fn snapshot(&self) -> TrackerSnapshot<R, D, K> {
        let (proxies, notes) = (&self.proxies, &self.proxies.notes);
        let boxes = proxies.previous.iter().copied();
        let touched = sorted(notes.touched.iter().copied()).into_iter();
        let touched = touched.map(|slot| (slot, proxies.get(slot).copied()));
        let of_state = |state| self.candidates.of_state(state);
        let overlapping = of_state(PairState::Held).chain(of_state(PairState::Near));
        let is_forbidden = |&pair: &_| proxies.are_rekeyed && !proxies.may_meet(pair);
        let acquainted = self.candidates.acquainted.iter();
        TrackerSnapshot {
            boxes: boxes.map(|b| b.is_valid().then_some(b)).collect(),
            keys: proxies.keys.clone(),
            touched: touched.collect(),
            volumes: proxies.volumes.snapshot(),
            revolumed: sorted(notes.revolumed.iter().copied()),
            near: sorted(of_state(PairState::Near)),
            forbidden: sorted(overlapping.filter(is_forbidden)),
            acquainted: acquainted.map(|slot| slot as u32).collect(),
            full_searches: self.full_searches,
        }
    }

    /// Restores a tracker from its serialized form, or says why no tracker has it. This one must be new.
    pub(crate) fn restore(
        &mut self,
        snapshot: TrackerSnapshot<R, D, K>,
    ) -> Result<(), &'static str> {
        let slots = snapshot.boxes.len();
        if slots > MAX_BOXES {
            return Err("snapshot: there are more slots than a kernel takes boxes");
        }
        if slots != snapshot.keys.len() {
            return Err("snapshot: there is not one filter key for each slot");
        }
        self.full_searches = snapshot.full_searches;
        self.make_room(slots);
        let proxies = &mut self.proxies;
        proxies.keys = snapshot.keys;
        for (previous, aabb) in proxies.previous.iter_mut().zip(snapshot.boxes) {
            *previous = aabb.unwrap_or(Aabb::ABSENT);
            if aabb.is_some_and(|aabb| !aabb.is_valid()) {
                return Err("snapshot: a box is not valid");
            }
        }
        proxies.are_filtered = proxies.keys.iter().any(|&key| key != K::default());
        proxies.volumes.restore(snapshot.volumes, slots)?;
        // Each fat box is the box itself, so a proxy that moves is searched for at once.
        proxies.fat_boxes.clone_from(&proxies.previous);
        proxies.boxes.clone_from(&proxies.previous);
        for (slot, aabb) in snapshot.touched {
            match (aabb, proxies.boxes.get(slot as usize)) {
                (_, None) => return Err("snapshot: a touched slot is out of range"),
                (None, _) => proxies.clear_box(slot),
                (Some(aabb), _) if aabb.is_valid() => proxies.place(slot, aabb),
                _ => return Err("snapshot: a box that was handed over is not valid"),
            }
        }
        let mut listed = snapshot.revolumed.iter().chain(&snapshot.acquainted);
        if listed.any(|&slot| slot as usize >= slots || !proxies.volumes.are_used) {
            return Err(
                "snapshot: a slot has another volume or is acquainted, and is out of range or none is in use",
            );
        }
        proxies.notes.revolumed = snapshot.revolumed;
        let mut kernel = GridSweep::default();
        let mut found = overlapping(&mut kernel, &proxies.fat_boxes, &proxies.keys);
        for &[a, b] in &snapshot.forbidden {
            let is_one = a < b
                && (b as usize) < slots
                && !proxies.may_meet([a, b])
                && overlap(&proxies.previous, [a, b]);
            if !is_one {
                return Err("snapshot: a pair is forbidden that is none, or may meet");
            }
        }
        proxies.are_rekeyed = !snapshot.forbidden.is_empty();
        found.extend(snapshot.forbidden);
        if !(snapshot.near.is_empty() || proxies.volumes.are_used) {
            return Err("snapshot: a pair is near, and no volume is in use");
        }
        self.candidates
            .restore(found, &snapshot.near, &snapshot.acquainted)?;
        let notes = &proxies.notes;
        let are_noted = SlotSet::of(&[&notes.touched[..], &notes.revolumed].concat());
        for &pair in &snapshot.near {
            proxies.volumes.note_near(pair, true);
            let volumes = &proxies.volumes;
            let may_begin = proxies.may_meet(pair) && volumes.meet(pair, R::ZERO);
            // A volume whose slot is noted is read, or has changed since the last update.
            if !are_noted.has_any(pair) && (volumes.are_stale(pair) || may_begin) {
                return Err(
                    "snapshot: a pair is not held although its volumes meet, or are not known",
                );
            }
        }
        Ok(())
    }
}

/// In order, so that equal states have equal snapshots with any number of threads.
fn sorted<T: Ord>(items: impl Iterator<Item = T>) -> Vec<T> {
    let mut sorted: Vec<_> = items.collect();
    sorted.sort_unstable();
    sorted
}
