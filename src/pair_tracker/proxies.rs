//! The proxies: one structure of arrays, by slot.
//!
//! Between two updates, placing, clearing and removing proxies only writes boxes and notes which slots were written. Nothing is searched
//! or compared until the next update, so a proxy may be written any number of times. Code that goes through many slots borrows all of them
//! as one [`ProxyChunk`], or gives each of several threads a chunk.

mod chunk;
mod pair_rules;

use super::foresight::Foresight;
use super::policy::are_many_touched;
use super::volumes::Volumes;
use super::{Colliders, FilterKey};
use crate::aabb::Aabb;
use crate::parallel::Section;
use crate::real::Real;
use crate::slot_set::SlotSet;
use crate::tuning::prices::SLOT;
pub(crate) use chunk::{Notes, ProxyChunk};
pub(super) use pair_rules::overlap;

/// The state of each slot, and notes of what has changed since the last update.
#[derive(Clone, Debug, Default)]
pub(crate) struct Proxies<R, const D: usize, K> {
    /// The box of each slot; all NaN, which overlaps nothing, where there is no proxy.
    pub(crate) boxes: Vec<Aabb<R, D>>,
    /// The boxes at the end of the last update; all NaN once a proxy is removed.
    pub(super) previous: Vec<Aabb<R, D>>,
    /// The fat box of each proxy; all NaN where there is no proxy, or a new one.
    pub(crate) fat_boxes: Vec<Aabb<R, D>>,
    pub(super) keys: Vec<K>,
    /// Whether any slot has had another key than the default one, with which all may meet.
    pub(super) are_filtered: bool,
    /// Whether pairs may be held that their keys forbid, because the key of a proxy with a box has changed at some time.
    pub(super) are_rekeyed: bool,
    /// The volume of each slot, if volumes are in use.
    pub(crate) volumes: Volumes<R, D>,
    pub(crate) notes: Notes,
    /// In an update, the set of the touched slots, if they are few.
    pub(super) touched: SlotSet,
    /// In an update, the set of the noted leavers.
    pub(super) leavers: SlotSet,
    /// In an update, the set of the slots whose volumes are noted.
    pub(super) revolumed: SlotSet,
    /// In an update, the slots whose boxes differ from those at the end of the last one, if volumes are in use.
    pub(super) renewed: SlotSet,
    /// In an update, how far apart the volumes of a held pair may be.
    pub(super) slack: R,
}

impl<R: Real, const D: usize, K: FilterKey> Proxies<R, D, K> {
    /// The number of slots that there is room for.
    pub(crate) fn len(&self) -> usize {
        self.boxes.len()
    }

    /// The box under this slot, if there is a proxy.
    pub(crate) fn get(&self, slot: u32) -> Option<&Aabb<R, D>> {
        self.boxes.get(slot as usize).filter(|b| b.is_valid())
    }

    /// The filter key of a slot.
    pub(crate) fn key(&self, slot: u32) -> K {
        self.keys[slot as usize]
    }

    /// Makes room for this number of slots, if there is less.
    #[cold]
    pub(crate) fn make_room(&mut self, slots: usize) {
        if slots > self.boxes.len() {
            for boxes in [&mut self.boxes, &mut self.previous, &mut self.fat_boxes] {
                boxes.resize(slots, Aabb::ABSENT);
            }
            self.keys.resize(slots, K::default());
            self.volumes.make_room(slots);
            self.touched.make_room(slots);
            self.leavers.make_room(slots);
            self.revolumed.make_room(slots);
            self.renewed.make_room(slots);
        }
    }

    /// All slots, to be written in place.
    #[inline(always)]
    pub(crate) fn all(&mut self) -> ProxyChunk<'_, R, D, K> {
        let volumes = self.volumes.chunks(usize::MAX).next();
        ProxyChunk {
            first_slot: 0,
            boxes: &mut self.boxes,
            fat_boxes: &self.fat_boxes,
            keys: &self.keys,
            volumes: volumes.expect("chunks never end"),
            notes: &mut self.notes,
        }
    }

    /// Chunks of this many slots, to be written by several threads. The caller [appends](Notes::append) their notes afterwards.
    pub(crate) fn chunks<'a>(
        &'a mut self,
        slots: usize,
        notes: impl IntoIterator<Item = &'a mut Notes>,
    ) -> impl Iterator<Item = ProxyChunk<'a, R, D, K>> {
        let boxes = self.boxes.chunks_mut(slots).zip(notes);
        let read = self.fat_boxes.chunks(slots).zip(self.keys.chunks(slots));
        let all = boxes.zip(read).zip(self.volumes.chunks(slots));
        all.enumerate().map(
            move |(i, (((boxes, notes), (fat_boxes, keys)), volumes))| ProxyChunk {
                first_slot: i * slots,
                boxes,
                fat_boxes,
                keys,
                volumes,
                notes,
            },
        )
    }

    /// Places or moves the proxy of a slot, for which there must be room. `aabb` must be valid.
    pub(crate) fn place(&mut self, slot: u32, aabb: Aabb<R, D>) {
        self.all().place(slot as usize, aabb);
    }

    /// Removes the box of a slot; its pairs end in the next update, with an event each. Its fat box and its candidates stay until then.
    pub(crate) fn clear_box(&mut self, slot: u32) {
        self.boxes[slot as usize] = Aabb::ABSENT;
        self.search_again(slot);
    }

    fn search_again(&mut self, slot: u32) {
        self.notes.touched.push(slot);
        self.notes.leavers.push(slot);
    }

    /// Sets the filter key of a slot, for which there must be room. If it changes, the proxy is searched for again. Held pairs stay,
    /// whether the new key allows them or not.
    pub(crate) fn set_key(&mut self, slot: u32, key: K) {
        let index = slot as usize;
        let former = std::mem::replace(&mut self.keys[index], key);
        if former == key {
            return;
        }
        self.are_filtered = true;
        self.are_rekeyed |= self.previous[index].is_valid();
        if self.boxes[index].is_valid() {
            self.search_again(slot);
        }
    }

    /// Notes the margin of boxes, and the distance by which they are extended: see [`Volumes::note_extents`].
    pub(crate) fn note_extents(&mut self, margin: R, reach: R) {
        if self.volumes.note_extents(margin, reach) {
            self.notes.revolumed.extend(0..self.boxes.len() as u32);
        }
        self.volumes.note_reach_of_boxes(reach);
    }

    /// Begins an update: reads the volumes that the notes name, and makes sets of the notes.
    pub(super) fn begin_update(&mut self, slack: R, colliders: &impl Colliders<R, D>) {
        self.slack = slack;
        // Pairs of volumes without half axes are tested without a look at whether they are stale, so these are read here in any case.
        self.volumes.pull(&mut self.notes.revolumed, colliders);
        self.leavers.extend(&self.notes.leavers);
        self.revolumed.extend(&self.notes.revolumed);
        let (touched, boxes, previous) = (&self.notes.touched, &self.boxes, &self.previous);
        if !are_many_touched(touched.len(), boxes.len()) {
            self.touched.extend(touched);
        }
        if self.volumes.are_used {
            let is_renewed = |&&slot: &&u32| boxes[slot as usize] != previous[slot as usize];
            self.renewed.extend(touched.iter().filter(is_renewed));
        }
    }

    /// Makes new fat boxes for the leavers.
    pub(super) fn inflate_leavers(&mut self, foresight: Foresight) {
        for &slot in self.leavers.slots() {
            let i = slot as usize;
            self.fat_boxes[i] = foresight.fat_box(&self.boxes[i], &self.previous[i]);
        }
    }

    /// Makes new fat boxes for all proxies, or for those that have moved or left theirs.
    pub(super) fn inflate(&mut self, foresight: Foresight, are_all: bool) {
        let (section, slots) = self.section();
        let boxes = self.boxes.chunks(slots).zip(self.previous.chunks(slots));
        let mut parts: Vec<_> = self.fat_boxes.chunks_mut(slots).zip(boxes).collect();
        section.for_each(&mut parts, |(fat_boxes, (boxes, previous))| {
            for (fat, (now, before)) in fat_boxes.iter_mut().zip(boxes.iter().zip(*previous)) {
                if are_all || now != before || !fat.contains(now) {
                    *fat = foresight.fat_box(now, before);
                }
            }
        });
    }

    /// Ends an update: makes the present boxes the previous ones, and clears the notes.
    pub(super) fn end_update(&mut self) {
        let touched = &self.notes.touched;
        if are_many_touched(touched.len(), self.boxes.len()) {
            let (section, slots) = self.section();
            let boxes = self.boxes.chunks(slots);
            let mut parts: Vec<_> = self.previous.chunks_mut(slots).zip(boxes).collect();
            section.for_each(&mut parts, |(previous, boxes)| {
                previous.copy_from_slice(boxes);
            });
        } else {
            for &slot in touched {
                self.previous[slot as usize] = self.boxes[slot as usize];
            }
        }
        self.notes.clear();
        self.touched.clear();
        self.leavers.clear();
        self.revolumed.clear();
        self.renewed.clear();
    }

    /// A section that goes through all slots, and the number of slots in each part of it.
    fn section(&self) -> (Section, usize) {
        let section = Section::of(self.boxes.len(), SLOT);
        (section, self.boxes.len().div_ceil(section.parts()))
    }
}
