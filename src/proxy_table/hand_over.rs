//! Boxes that are handed over between two updates, by an engine that knows them already.
//!
//! They count in the next update. For a known collider, nothing is read again; an unknown one is read once, for its filter
//! key. Nearly all are known colliders that have moved, which one tight loop deals with.
//!
//! A box for an unknown collider has to wait: whether there is such a collider, and whom it may meet, is only known when the
//! next update reads it. Until then its slot has that box, so that queries find it.

use std::collections::BTreeMap;

use super::{BoxSource, Handle, ProxyTable, Reading, is_known};
use crate::aabb::Aabb;
use crate::pair_tracker::{BoxUpdate, FilterKey};
use crate::real::Real;
use crate::stopwatch::Phase;
use crate::tuning::update::ROOM_AHEAD;
use crate::volume::Volume;

/// What the next update has to look at, if it exists, by slot and generation: with boxes if some were handed over; otherwise it has to be
/// read.
pub(super) type Pending<R, const D: usize> = BTreeMap<(u32, u32), Option<HandedOver<R, D>>>;

/// What boxes were handed over for a collider that is not known.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize),
    serde(bound(
        serialize = "[R; D]: serde::Serialize",
        deserialize = "[R; D]: serde::Deserialize<'de>"
    ))
)]
pub(super) struct HandedOver<R, const D: usize> {
    /// The first one, renewed as that of a known collider would have been by the others.
    pub(super) held: Aabb<R, D>,
    pub(super) last: Aabb<R, D>,
}

impl<R: Real, const D: usize, M: Clone + Default + Send, K: FilterKey> ProxyTable<R, D, M, K> {
    /// Takes boxes that are handed over, without the margin, as a part of the next [update](Self::update). Colliders keep
    /// their filter keys. Returns the slots whose boxes it has written; some may repeat. **O(1)** each.
    ///
    /// `volume` is asked for volumes, if they are in use, but not of balls, which are where their boxes are, and of parts.
    pub(crate) fn hand_over<H: Handle>(
        &mut self,
        boxes: impl IntoIterator<Item = (H, Aabb<R, D>)>,
        margin: R,
        volume: impl Fn(H, &mut M, &Aabb<R, D>) -> Volume<R, D>,
    ) -> &[u32] {
        self.begin();
        self.tracker.stopwatch.enter(Phase::Read);
        self.tracker.proxies.forget_repeats();
        let first_touched = self.touched().len();
        let mut boxes = boxes.into_iter();
        loop {
            let touched = self.touched().len();
            let mut proxies = self.tracker.proxies.all();
            let (generations, memos) = (&self.generations[..], &mut self.memos[..]);
            let mut listed = 0;
            // Moves all up to the first that is more than a move.
            let unusual = loop {
                let Some((handle, aabb)) = boxes.next() else {
                    break None;
                };
                listed += 1;
                let (slot, generation) = handle.into_raw_parts();
                let i = slot as usize;
                let is_moved = is_known(generations, slot, generation)
                    && proxies.follow(i, &aabb, margin, |volumes, is_renewed| {
                        let by_box = volumes.set_by_box(i, &aabb, is_renewed);
                        by_box.or_else(|| {
                            let volume = volume(handle, &mut memos[i], &aabb);
                            volumes.set(i, &volume, is_renewed)
                        })
                    });
                if !is_moved {
                    break Some((handle, aabb));
                }
            };
            self.gathered.listed += listed;
            self.gathered.moved += self.touched().len() - touched;
            let Some((handle, aabb)) = unusual else {
                break;
            };
            let Some(slot) = self.slot_of(handle) else {
                self.keep_pending(handle, aabb, margin);
                continue;
            };
            let proxies = &mut self.tracker.proxies;
            let (key, are_used) = (proxies.key(slot), proxies.volumes().are_used());
            let by_box = proxies.all().volume_by_box(slot as usize, &aabb);
            self.admit(handle, margin, |memo| {
                let volume = match by_box {
                    _ if !are_used => Volume::BOX,
                    Some(volume) => volume,
                    None => volume(handle, memo, &aabb),
                };
                Some(Reading { aabb, key, volume })
            });
        }
        self.tracker.stopwatch.leave();
        &self.touched()[first_touched..]
    }

    /// Keeps a box until the next update can look for its collider. A collider of an earlier generation than the known one is gone, so
    /// its box is ignored.
    #[cold]
    fn keep_pending(&mut self, handle: impl Handle, aabb: Aabb<R, D>, margin: R) {
        let (slot, generation) = handle.into_raw_parts();
        let index = slot as usize;
        if self.generations.get(index).copied().flatten() > Some(generation) {
            return;
        }
        // Memory grows with the highest slot, so a collider that may not exist must not have one far beyond all known ones.
        if index < self.known_slots + ROOM_AHEAD {
            self.make_room(index + 1);
            let known = self.generations[index];
            if let Some(known) = known {
                // Probably its removal has not been reported yet.
                self.pending.insert((slot, known), None);
            }
            if aabb.is_valid() {
                self.place(slot, aabb);
            } else if known.is_none() {
                self.tracker.proxies.clear_box(slot);
            }
        }
        let pending = self.pending.entry((slot, generation)).or_default();
        let held = pending.map_or(Aabb::ABSENT, |former| former.held);
        let held = match BoxUpdate::of(&held, &aabb, margin) {
            BoxUpdate::Keep => held,
            BoxUpdate::Renew(renewed) => renewed,
            BoxUpdate::Recheck => aabb,
        };
        *pending = Some(HandedOver { held, last: aabb });
    }

    /// Looks at the pending colliders, except those that have been removed in the meantime.
    pub(super) fn admit_pending<S>(&mut self, removed: &[S::Handle], source: &S, margin: R)
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        let mut pending = std::mem::take(&mut self.pending);
        for &(slot, _) in pending.keys() {
            if self.generations.get(slot as usize) == Some(&None) {
                // The box was only there for queries.
                self.tracker.proxies.clear_box(slot);
            }
        }
        for handle in removed {
            pending.remove(&handle.into_raw_parts());
        }
        for ((slot, generation), boxes) in pending {
            let handle = S::Handle::from_raw_parts(slot, generation);
            self.admit_read(handle, boxes, source, margin);
        }
    }
}
