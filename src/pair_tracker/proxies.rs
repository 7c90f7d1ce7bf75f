//! The proxies: one structure of arrays, by slot.
//!
//! Between two updates, placing, clearing and removing proxies only writes boxes and notes which slots it has written. Nothing is
//! searched or compared until the next `finish`, so a proxy may be written any number of times. What works through many slots
//! borrows all of them as one [`ProxyChunk`], or each of several threads a chunk of its own.

use super::FilterKey;
use super::chunk::ProxyChunk;
use super::foresight::Foresight;
use super::policy::are_most_touched;
use super::volumes::Volumes;
use crate::aabb::Aabb;
use crate::bit_set::{BitSet, gather};
use crate::parallel::Section;
use crate::real::Real;
use crate::slot_set::SlotSet;
use crate::tuning::prices::SLOT;
use crate::tuning::update::MOST_NOTES_A_SLOT;
use crate::volume::Volume;

/// What is known of each slot, and what has changed since the last `finish`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Proxies<R, const D: usize, K> {
    /// The box of each slot; all NaN, which overlaps nothing, where there is no proxy.
    pub(crate) boxes: Vec<Aabb<R, D>>,
    /// The boxes as they were at the end of the last `finish`; all NaN too once a proxy is removed.
    pub(super) previous: Vec<Aabb<R, D>>,
    /// The fat box of each proxy; all NaN where there is none, or none yet.
    pub(crate) fat_boxes: Vec<Aabb<R, D>>,
    pub(super) keys: Vec<K>,
    /// Whether a slot has had another key than the default one, with which all may meet.
    pub(super) are_filtered: bool,
    /// Whether a proxy with a box has had its key changed, so that pairs may be held that the keys now forbid.
    pub(super) are_rekeyed: bool,
    /// The volume of each slot, if pairs are told apart by them.
    pub(super) volumes: Volumes<R, D>,
    pub(super) notes: Notes,
    /// In a `finish`, the slots whose boxes have left their fat boxes, have none yet, or are gone.
    pub(super) leavers: SlotSet,
    /// In a `finish`, the slots that have another box than at the end of the last one, if volumes are in use.
    pub(super) renewed: BitSet,
    /// In a `finish`, how far the volumes of a held pair may be apart.
    pub(super) slack: R,
}

/// Slots that were written since the last `finish`; each may repeat.
#[derive(Clone, Debug, Default)]
pub(crate) struct Notes {
    /// Whose boxes or keys were written.
    pub(super) touched: Vec<u32>,
    /// Those of them whose boxes have left their fat boxes, or that have to be searched for all the same.
    pub(super) left: Vec<u32>,
    /// Whose volumes have changed, but not their boxes at that time.
    pub(super) revolumed: Vec<u32>,
}

impl<R: Real, const D: usize, K: FilterKey> Proxies<R, D, K> {
    /// No slots yet. `volumes` says whether volumes are in use.
    pub(super) fn new(volumes: bool) -> Self {
        Self {
            volumes: Volumes::new(volumes),
            ..Self::default()
        }
    }

    /// The number of slots that there is room for.
    pub(crate) fn len(&self) -> usize {
        self.boxes.len()
    }

    /// The box under this slot, if there is a proxy.
    pub(crate) fn get(&self, slot: u32) -> Option<&Aabb<R, D>> {
        self.boxes.get(slot as usize).filter(|b| b.is_valid())
    }

    /// The slots that have a proxy, with their boxes.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (u32, &Aabb<R, D>)> {
        (0..).zip(&self.boxes).filter(|(_, b)| b.is_valid())
    }

    /// The filter key of a slot.
    pub(crate) fn key(&self, slot: u32) -> K {
        self.keys[slot as usize]
    }

    /// The volumes, if pairs are told apart by them.
    pub(crate) fn volumes(&self) -> &Volumes<R, D> {
        &self.volumes
    }

    /// The volumes, to note what all of them depend on.
    pub(crate) fn volumes_mut(&mut self) -> &mut Volumes<R, D> {
        &mut self.volumes
    }

    /// The slots whose boxes or keys were written since the last `finish`; may repeat.
    pub(crate) fn touched(&self) -> &[u32] {
        &self.notes.touched
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
            self.leavers.make_room(slots);
        }
    }

    /// All slots, to be written in place.
    #[inline(always)]
    pub(crate) fn all(&mut self) -> ProxyChunk<'_, R, D, K> {
        ProxyChunk {
            first_slot: 0,
            boxes: &mut self.boxes,
            fat_boxes: &self.fat_boxes,
            keys: &self.keys,
            volumes: self.volumes.all(),
            notes: &mut self.notes,
        }
    }

    /// Chunks of this many slots, to be written by several threads. What they note is to be [taken in](Self::note).
    pub(crate) fn chunks<'a>(
        &'a mut self,
        slots: usize,
        notes: impl IntoIterator<Item = &'a mut Notes>,
    ) -> impl Iterator<Item = ProxyChunk<'a, R, D, K>> {
        let boxes = self.boxes.chunks_mut(slots).zip(notes);
        let rest = self.fat_boxes.chunks(slots).zip(self.keys.chunks(slots));
        let all = boxes.zip(rest).zip(self.volumes.chunks(slots));
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

    /// Takes in the notes of a chunk.
    pub(crate) fn note(&mut self, notes: &mut Notes) {
        self.notes.touched.append(&mut notes.touched);
        self.notes.left.append(&mut notes.left);
        self.notes.revolumed.append(&mut notes.revolumed);
    }

    /// Places or moves the proxy of a slot, for which there must be room. `aabb` must be valid.
    pub(crate) fn place(&mut self, slot: u32, aabb: Aabb<R, D>) {
        self.all().place(slot as usize, aabb);
    }

    /// Takes the box of a slot away; its pairs end with an event each. Its fat box stays until then, like its candidates.
    pub(crate) fn clear_box(&mut self, slot: u32) {
        if let Some(aabb) = self.boxes.get_mut(slot as usize) {
            *aabb = Aabb::ABSENT;
            self.search_anew(slot);
        }
    }

    /// Removes a proxy; its pairs end without an event.
    pub(crate) fn remove(&mut self, slot: u32) {
        if let Some(previous) = self.previous.get_mut(slot as usize) {
            *previous = Aabb::ABSENT;
            self.clear_box(slot);
        }
    }

    fn search_anew(&mut self, slot: u32) {
        self.notes.touched.push(slot);
        self.notes.left.push(slot);
    }

    /// Sets the filter key of a slot, for which there must be room. If it changes, the proxy is searched for anew. Pairs that are held
    /// stay, whether the new key allows them or not.
    pub(crate) fn set_key(&mut self, slot: u32, key: K) {
        let index = slot as usize;
        let former = std::mem::replace(&mut self.keys[index], key);
        if former == key {
            return;
        }
        self.are_filtered = true;
        self.are_rekeyed |= self.previous[index].is_valid();
        if self.boxes[index].is_valid() {
            self.search_anew(slot);
        }
    }

    /// Sets the volume of a slot, for which there must be room, and whose box `is_renewed` at the same time or not.
    pub(crate) fn set_volume(&mut self, slot: u32, volume: &Volume<R, D>, is_renewed: bool) {
        if self.volumes.set(slot, volume, is_renewed) && !is_renewed {
            self.notes.revolumed.push(slot);
        }
    }

    /// Sets the volume of a slot as it is now, without a margin.
    pub(crate) fn reset_volume(&mut self, slot: u32, volume: &Volume<R, D>) {
        self.volumes.set(slot, volume, true);
        self.notes.revolumed.push(slot);
    }

    /// Forgets what was noted more than once since the last `finish`, if it takes much memory. **O(1)** a note.
    pub(crate) fn forget_repeats(&mut self) {
        let notes = &mut self.notes;
        for noted in [&mut notes.touched, &mut notes.left, &mut notes.revolumed] {
            if noted.len() > MOST_NOTES_A_SLOT * self.boxes.len() {
                noted.sort_unstable();
                noted.dedup();
            }
        }
    }

    /// Prepares for comparing: makes sets of what was noted.
    pub(super) fn begin_finish(&mut self, slack: R) {
        self.slack = slack;
        self.volumes.note_moves();
        for &slot in &self.notes.left {
            self.leavers.insert(slot);
        }
        if self.volumes.are_used() {
            let (boxes, previous) = (&self.boxes, &self.previous);
            let slots = boxes.len();
            if are_most_touched(self.notes.touched.len(), slots) {
                return self.renewed.ask(slots, SLOT, |slots| {
                    let boxes = boxes[slots.clone()].iter().zip(&previous[slots]);
                    // Where there is no box, it does not equal itself.
                    gather(boxes, |(now, before)| (now != before) & now.is_valid())
                });
            }
            self.renewed.resize(slots);
            for &slot in &self.notes.touched {
                let i = slot as usize;
                if boxes[i] != previous[i] {
                    self.renewed.insert(i);
                }
            }
        }
    }

    /// Inflates the boxes that have left their fat boxes anew.
    pub(super) fn inflate_leavers(&mut self, foresight: Foresight) {
        for &slot in self.leavers.slots() {
            let i = slot as usize;
            self.fat_boxes[i] = foresight.fat_box(&self.boxes[i], &self.previous[i]);
        }
    }

    /// Inflates the boxes that were touched.
    pub(super) fn inflate_touched(&mut self, foresight: Foresight) {
        if are_most_touched(self.notes.touched.len(), self.boxes.len()) {
            // The rest has not moved, or is back inside its fat box.
            return self.inflate(foresight, |fat, now, before| {
                now != before || !fat.contains(now)
            });
        }
        for &slot in &self.notes.touched {
            let i = slot as usize;
            self.fat_boxes[i] = foresight.fat_box(&self.boxes[i], &self.previous[i]);
        }
    }

    /// Inflates all boxes.
    pub(super) fn inflate_all(&mut self, foresight: Foresight) {
        self.inflate(foresight, |_, _, _| true);
    }

    /// Inflates the boxes for which it is due, going by their fat boxes, their boxes, and those before.
    fn inflate(
        &mut self,
        foresight: Foresight,
        is_due: impl Fn(&Aabb<R, D>, &Aabb<R, D>, &Aabb<R, D>) -> bool + Send + Sync,
    ) {
        let (section, slots) = self.section();
        let boxes = self.boxes.chunks(slots).zip(self.previous.chunks(slots));
        let mut parts: Vec<_> = self.fat_boxes.chunks_mut(slots).zip(boxes).collect();
        section.for_each(&mut parts, |(fat_boxes, (boxes, previous))| {
            for (fat, (now, before)) in fat_boxes.iter_mut().zip(boxes.iter().zip(*previous)) {
                if is_due(fat, now, before) {
                    *fat = foresight.fat_box(now, before);
                }
            }
        });
    }

    /// Makes the present boxes the previous ones, and forgets the notes.
    pub(super) fn commit(&mut self) {
        let touched = &self.notes.touched;
        if are_most_touched(touched.len(), self.boxes.len()) {
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
        if self.volumes.are_used() {
            self.renewed.clear_around(touched);
        }
        let notes = &mut self.notes;
        for noted in [&mut notes.touched, &mut notes.left, &mut notes.revolumed] {
            noted.clear();
        }
        self.leavers.clear();
    }

    /// A section that goes through all slots, and how many of them make a part of it.
    fn section(&self) -> (Section, usize) {
        let section = Section::of(self.boxes.len(), SLOT);
        (section, self.boxes.len().div_ceil(section.parts()).max(1))
    }
}
