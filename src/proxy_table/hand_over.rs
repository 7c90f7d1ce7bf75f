//! Boxes that are handed over between two updates, by an engine that knows them already.
//!
//! They count in the next update. For a known collider, nothing is read again; an unknown one is read once, for its filter
//! key. Nearly all are known colliders that have moved, which one tight loop deals with.
//!
//! A box for an unknown collider has to wait: whether there is such a collider, and whom it may meet, is only known when the
//! next update reads it. Until then its slot has that box, so that queries find it.

use std::collections::BTreeMap;

use super::slot_run::{SlotRun, slot_runs};
use super::{BoxSource, Handle, ProxyTable, Reading};
use crate::aabb::Aabb;
use crate::pair_tracker::{BoxUpdate, FilterKey};
use crate::parallel::{self, Section};
use crate::real::Real;
use crate::stopwatch::Phase;
use crate::tuning::prices::READ;
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
    pub(crate) fn hand_over<H: Handle, B: Copy + Into<Aabb<R, D>> + Sync>(
        &mut self,
        boxes: &[(H, B)],
        margin: R,
        volume: impl Fn(H, &mut M, &Aabb<R, D>) -> Volume<R, D> + Sync,
    ) -> &[u32] {
        self.begin();
        let shared = parallel::shared();
        self.tracker.stopwatch.enter(Phase::Read);
        self.tracker.proxies.forget_repeats();
        let first_touched = self.touched().len();
        let price = self.tracker.proxies.volumes().price(READ);
        let section = Section::of(boxes.len(), price);
        self.gathered.listed += boxes.len();
        if section.parts() > 1 {
            let unusual = self.follow_in_parts(section, boxes, margin, &volume);
            self.gathered.moved += self.touched().len() - first_touched;
            for (handle, aabb) in unusual.into_iter().map(|place| boxes[place]) {
                self.take_in(handle, aabb.into(), margin, &volume);
            }
        } else {
            let mut boxes = boxes.iter();
            while let Some(&(handle, aabb)) =
                section.run(|| self.follow_up_to(&mut boxes, margin, &volume))
            {
                self.take_in(handle, aabb.into(), margin, &volume);
            }
        }
        self.tracker.stopwatch.leave();
        self.tracker
            .stopwatch
            .times
            .shared
            .add([shared, parallel::shared()]);
        &self.touched()[first_touched..]
    }

    /// Moves all up to the first that is more than a move, and returns that.
    fn follow_up_to<'a, H: Handle, B: Copy + Into<Aabb<R, D>>>(
        &mut self,
        boxes: &mut impl Iterator<Item = &'a (H, B)>,
        margin: R,
        volume: &impl Fn(H, &mut M, &Aabb<R, D>) -> Volume<R, D>,
    ) -> Option<&'a (H, B)> {
        let touched = self.touched().len();
        let mut all = SlotRun {
            proxies: self.tracker.proxies.all(),
            generations: &self.generations,
            memos: &mut self.memos,
        };
        let unusual = boxes.find(|&&(handle, aabb)| {
            let (slot, generation) = handle.into_raw_parts();
            let is_followed = all.follow(
                slot as usize,
                generation,
                &aabb.into(),
                margin,
                |memo, aabb| volume(handle, memo, aabb),
            );
            !is_followed
        });
        self.gathered.moved += self.touched().len() - touched;
        unusual
    }

    /// Moves what is no more than a move, by several threads, each of which has a run of slots. Returns the others by their places,
    /// ascending, and for each of them what follows it in its run, so that what is handed over for a collider is taken in order.
    fn follow_in_parts<H: Handle, B: Copy + Into<Aabb<R, D>> + Sync>(
        &mut self,
        section: Section,
        boxes: &[(H, B)],
        margin: R,
        volume: &(impl Fn(H, &mut M, &Aabb<R, D>) -> Volume<R, D> + Sync),
    ) -> Vec<usize> {
        let parts = section.parts();
        let slots_a_part = self.generations.len().div_ceil(parts).max(1);
        let boxes_a_part = boxes.len().div_ceil(parts).max(1);
        // First boxes are shared out, to tell whose slots they are of.
        let starts = (0..).step_by(boxes_a_part).zip(boxes.chunks(boxes_a_part));
        let mut dealt: Vec<_> = starts
            .map(|(start, boxes)| (start, boxes, vec![Vec::new(); parts + 1]))
            .collect();
        section.for_each(&mut dealt, |(start, boxes, places)| {
            for (place, (handle, _)) in (*start..).zip(*boxes) {
                let (slot, _) = handle.into_raw_parts();
                places[(slot as usize / slots_a_part).min(parts)].push(place);
            }
        });
        let places = |part: usize| {
            let of_part = dealt.iter().map(move |(_, _, places)| &places[part]);
            of_part.flatten().copied()
        };
        // Then slots are.
        let (proxies, notes) = (&mut self.tracker.proxies, &mut self.reader.notes);
        let runs = slot_runs(
            proxies,
            &self.generations,
            &mut self.memos,
            notes,
            slots_a_part,
        );
        let runs = runs.enumerate();
        let mut followed: Vec<_> = runs.map(|(part, run)| (part, run, Vec::new())).collect();
        section.for_each(&mut followed, |(part, run, unusual)| {
            let mut places = places(*part);
            let first = places.find(|&place| {
                let (handle, aabb) = boxes[place];
                let (slot, generation) = handle.into_raw_parts();
                let i = slot as usize - slots_a_part * *part;
                let is_followed = run.follow(i, generation, &aabb.into(), margin, |memo, aabb| {
                    volume(handle, memo, aabb)
                });
                !is_followed
            });
            unusual.extend(first);
            unusual.extend(places);
        });
        let unusual = followed.into_iter().flat_map(|(_, _, unusual)| unusual);
        let mut unusual: Vec<_> = unusual.chain(places(parts)).collect();
        unusual.sort_unstable();
        for notes in notes {
            self.tracker.proxies.note(notes);
        }
        unusual
    }

    /// Takes a box that is perhaps more than a move.
    fn take_in<H: Handle>(
        &mut self,
        handle: H,
        aabb: Aabb<R, D>,
        margin: R,
        volume: impl Fn(H, &mut M, &Aabb<R, D>) -> Volume<R, D>,
    ) {
        let Some(slot) = self.slot_of(handle) else {
            return self.keep_pending(handle, aabb, margin);
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
