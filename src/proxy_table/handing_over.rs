//! Boxes that are handed over between two updates, by an engine that knows them already.
//!
//! They count in the next update. For a known collider, nothing is read again; an unknown one is read once, for its filter
//! key. Nearly all are known colliders that have moved, which one tight loop deals with.
//!
//! A box for an unknown collider has to wait: whether there is such a collider, and whom it may meet, is only known when the
//! next update reads it. Until then its slot has that box, so that queries find it.

use std::collections::{BTreeMap, BTreeSet};

use super::verdict::Verdict;
use super::{BoxSource, Handle, ProxyTable, Reading, is_known};
use crate::pair_tracker::FilterKey;
use crate::stopwatch::Phase;
use crate::tuning::update::ROOM_AHEAD;
use crate::volume::{Volume, VolumeKind};
use crate::{Aabb, Real};

/// What the next update has to look at, if it exists, by slot and generation: with boxes if some were handed over; otherwise it has to be
/// read.
pub(super) type Awaited<R, const D: usize> = BTreeMap<(u32, u32), Option<HandedOver<R, D>>>;

/// What boxes were handed over for a collider that is not known.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(
    feature = "serde-serialize",
    derive(serde::Serialize, serde::Deserialize),
    serde(bound(
        serialize = "R: serde::Serialize",
        deserialize = "R: Real + serde::Deserialize<'de>"
    ))
)]
pub(super) struct HandedOver<R, const D: usize> {
    /// The first one, renewed as that of a known collider would have been by the others.
    held: Aabb<R, D>,
    last: Aabb<R, D>,
}

impl<R: Real, const D: usize> HandedOver<R, D> {
    /// After one more box.
    fn followed_by(former: Option<Self>, aabb: Aabb<R, D>, margin: R) -> Self {
        let held = former.map_or(Aabb::ABSENT, |former| former.held);
        let held = match Verdict::of(&held, &aabb, margin) {
            Verdict::Keep => held,
            Verdict::Renew(renewed) => renewed,
            Verdict::Recheck => aabb,
        };
        Self { held, last: aabb }
    }
}

impl<R: Real, const D: usize, M: Clone + Default + Send, K: FilterKey> ProxyTable<R, D, M, K> {
    /// Takes boxes that are handed over, without the margin, as a part of the next [update](Self::update). Colliders keep
    /// their filter keys. **O(1)** each.
    ///
    /// `volume` is asked for volumes, if they are in use, but not of balls, which are where their boxes are, and of parts.
    pub(crate) fn hand_over<H: Handle>(
        &mut self,
        boxes: impl IntoIterator<Item = (H, Aabb<R, D>)>,
        margin: R,
        volume: impl Fn(H, &mut M, &Aabb<R, D>) -> Volume<R, D>,
    ) {
        self.begin(margin);
        self.tracker.stopwatch.enter(Phase::Read);
        self.tracker.forget_repeats();
        let mut boxes = boxes.into_iter();
        while let Some((handle, aabb)) = self.move_known(&mut boxes, margin, &volume) {
            self.gathered.listed += 1;
            if let Some(slot) = self.slot_of(handle) {
                let key = self.tracker.key(slot);
                let volumes = self.tracker.volumes();
                let (are_used, by_box) = (volumes.are_used(), volumes.by_box(slot, &aabb));
                self.admit(handle, margin, |memo| {
                    let volume = match by_box {
                        _ if !are_used => Volume::BOX,
                        Some(volume) => volume,
                        None => volume(handle, memo, &aabb),
                    };
                    Some(Reading { aabb, key, volume })
                });
            } else {
                self.await_collider(handle, aabb, margin);
            }
        }
        self.tracker.stopwatch.leave();
    }

    /// Moves known proxies, up to the first box that is more than a move, which is returned.
    fn move_known<H: Handle>(
        &mut self,
        boxes: &mut impl Iterator<Item = (H, Aabb<R, D>)>,
        margin: R,
        volume: &impl Fn(H, &mut M, &Aabb<R, D>) -> Volume<R, D>,
    ) -> Option<(H, Aabb<R, D>)> {
        let Self {
            tracker,
            generations,
            memos,
            gathered,
            ..
        } = self;
        let has_volumes = tracker.volumes().are_used();
        let mut mover = tracker.mover();
        let (mut listed, mut moved) = (0, 0);
        let unusual = loop {
            let Some((handle, aabb)) = boxes.next() else {
                break None;
            };
            let (slot, generation) = handle.into_raw_parts();
            if !is_known(generations, slot, generation) {
                break Some((handle, aabb));
            }
            let verdict = Verdict::of(mover.held(slot), &aabb, margin);
            let is_renewed = match verdict {
                Verdict::Keep => false,
                Verdict::Renew(renewed) => {
                    mover.place(slot, renewed);
                    moved += 1;
                    true
                }
                Verdict::Recheck => break Some((handle, aabb)),
            };
            if has_volumes {
                let index = slot as usize;
                match mover.volumes().kind(index) {
                    VolumeKind::Ball => mover.stir_ball(slot, &aabb, is_renewed),
                    VolumeKind::Part => {}
                    kind => {
                        let volume = volume(handle, &mut memos[index], &aabb);
                        if volume.kind != kind {
                            break Some((handle, aabb));
                        }
                        mover.stir(slot, &volume, is_renewed);
                    }
                }
            }
            listed += 1;
        };
        gathered.listed += listed;
        gathered.moved += moved;
        unusual
    }

    /// Keeps a box until the next update can look for its collider.
    #[cold]
    fn await_collider(&mut self, handle: impl Handle, aabb: Aabb<R, D>, margin: R) {
        let (slot, generation) = handle.into_raw_parts();
        let index = slot as usize;
        // Memory grows with the highest slot, so a collider that may not exist must not have one far beyond all known ones.
        if index < self.known_slots + ROOM_AHEAD {
            self.make_room(index + 1);
            if let Some(known) = self.generations[index] {
                // Probably its removal has not been reported yet.
                self.awaited.insert((slot, known), None);
            }
            let is_known = self.generations[index].is_some();
            if aabb.is_valid() {
                if is_known && self.tracker.get(slot).is_none() {
                    self.stats.proxies += 1;
                    self.stats.refused -= 1;
                }
                self.tracker.place(slot, aabb);
            } else if !is_known {
                self.tracker.refuse(slot);
            }
        }
        let awaited = self.awaited.entry((slot, generation)).or_default();
        *awaited = Some(HandedOver::followed_by(*awaited, aabb, margin));
    }

    /// Looks at the awaited colliders, except those that have been removed in the meantime.
    pub(super) fn admit_awaited<S>(&mut self, removed: &[S::Handle], source: &S, margin: R)
    where
        S: BoxSource<R, D, Memo = M, Key = K>,
    {
        if self.awaited.is_empty() {
            return;
        }
        let removed: BTreeSet<_> = removed
            .iter()
            .map(|handle| handle.into_raw_parts())
            .collect();
        let are_used = self.tracker.volumes().are_used();
        for ((slot, generation), boxes) in std::mem::take(&mut self.awaited) {
            if self.generations.get(slot as usize) == Some(&None) {
                // The box was only there for queries.
                self.tracker.refuse(slot);
            }
            if removed.contains(&(slot, generation)) {
                continue;
            }
            let handle = S::Handle::from_raw_parts(slot, generation);
            self.admit(handle, margin, |memo| {
                let read = Reading::of(source, handle, memo, are_used)?;
                Some(match boxes {
                    Some(HandedOver { held, last }) => Reading {
                        aabb: held,
                        volume: read.volume.in_box(&last),
                        ..read
                    },
                    None => read,
                })
            });
        }
    }
}
