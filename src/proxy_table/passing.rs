//! Boxes that the engine passes between two updates, because it has computed them already.
//!
//! They count in the next update. The table does not read a known collider again, and nearly all boxes are moves of known colliders, which
//! one tight loop applies.
//!
//! Only the next update can tell whether an unknown collider exists and what it may meet, so that update reads it. Until then its slot has
//! the passed box, for queries.

use std::collections::BTreeSet;

use super::slot_chunk::{SlotChunk, slot_chunks};
use super::{ColliderSource, Handle, ProxyTable, Reading};
use crate::aabb::Aabb;
use crate::pair_tracker::FilterKey;
use crate::parallel::Section;
use crate::real::Real;
use crate::tuning::update::ROOM_AHEAD;

/// The colliders that the next update reads if they exist, by slot and generation.
pub(super) type Pending = BTreeSet<(u32, u32)>;

impl<R: Real, const D: usize, M: Clone + Default + Send + Sync, K: FilterKey>
    ProxyTable<R, D, M, K>
{
    /// Sets boxes without their margin, as a part of the next [update](Self::update). Colliders keep their filter keys. Returns the slots
    /// whose boxes it has written; some may repeat. **O(1)** for the box of each known collider.
    ///
    /// `reach` is the distance by which the boxes are extended.
    pub(crate) fn set_boxes<H: Handle, B: Copy + Into<Aabb<R, D>> + Sync>(
        &mut self,
        boxes: &[(H, B)],
        [margin, reach]: [R; 2],
    ) -> &[u32] {
        self.is_begun = true;
        self.tracker.proxies.volumes.note_reach_of_boxes(reach);
        self.tracker.proxies.forget_repeats();
        let first_touched = self.touched().len();
        let section = self.reading_section(boxes.len());
        if section.parts() > 1 {
            let unusual = self.follow_in_parts(section, boxes, margin);
            for (handle, aabb) in unusual.into_iter().map(|place| boxes[place]) {
                self.set_box(handle, aabb.into(), margin);
            }
        } else {
            let mut boxes = boxes.iter();
            while let Some(&(handle, aabb)) = self.follow_up_to(&mut boxes, margin) {
                self.set_box(handle, aabb.into(), margin);
            }
        }
        &self.touched()[first_touched..]
    }

    /// Moves proxies up to the first one that needs more than a move, and returns that.
    fn follow_up_to<'a, H: Handle, B: Copy + Into<Aabb<R, D>>>(
        &mut self,
        boxes: &mut impl Iterator<Item = &'a (H, B)>,
        margin: R,
    ) -> Option<&'a (H, B)> {
        let mut all = SlotChunk {
            proxies: self.tracker.proxies.all(),
            generations: &self.generations,
            memos: &mut self.memos,
        };
        boxes.find(|&&(handle, aabb)| !all.follow(handle, &aabb.into(), margin))
    }

    /// Moves proxies on several threads, each of which has a chunk of slots. Returns the ascending indices of the boxes that it has not
    /// applied: those that need more than a move, and later ones of the same slots, so that the boxes of a collider are applied in order.
    pub(super) fn follow_in_parts<H: Handle, B: Copy + Into<Aabb<R, D>> + Sync>(
        &mut self,
        section: Section,
        boxes: &[(H, B)],
        margin: R,
    ) -> Vec<usize> {
        let parts = section.parts();
        let slots_a_part = self.generations.len().div_ceil(parts).max(1);
        let boxes_a_part = boxes.len().div_ceil(parts).max(1);
        // First, each thread sorts some of the boxes by the chunk that they belong to; in the last place are those of slots without room.
        let part_of = |slot: usize| match slot < self.generations.len() {
            true => slot / slots_a_part,
            false => parts,
        };
        let starts = (0..).step_by(boxes_a_part).zip(boxes.chunks(boxes_a_part));
        let mut dealt: Vec<_> = starts
            .map(|(start, boxes)| (start, boxes, vec![Vec::new(); parts + 1]))
            .collect();
        section.for_each(&mut dealt, |(start, boxes, places)| {
            for (place, (handle, _)) in (*start..).zip(*boxes) {
                let (slot, _) = handle.into_raw_parts();
                places[part_of(slot as usize)].push(place);
            }
        });
        let places = |part: usize| {
            let of_part = dealt.iter().map(move |(_, _, places)| &places[part]);
            of_part.flatten().copied()
        };
        // Then each thread applies the boxes of one chunk.
        let (proxies, notes) = (&mut self.tracker.proxies, &mut self.reader.notes);
        let chunks = slot_chunks(
            proxies,
            &self.generations,
            &mut self.memos,
            notes,
            slots_a_part,
        );
        let chunks = chunks.enumerate();
        let mut followed: Vec<_> = chunks
            .map(|(part, chunk)| (part, chunk, Vec::new()))
            .collect();
        section.for_each(&mut followed, |(part, chunk, unusual)| {
            let mut slots = BTreeSet::new();
            for place in places(*part) {
                let (handle, aabb) = boxes[place];
                let (slot, _) = handle.into_raw_parts();
                if slots.contains(&slot) || !chunk.follow(handle, &aabb.into(), margin) {
                    slots.insert(slot);
                    unusual.push(place);
                }
            }
        });
        let unusual = followed.into_iter().flat_map(|(_, _, unusual)| unusual);
        let mut unusual: Vec<_> = unusual.chain(places(parts)).collect();
        unusual.sort_unstable();
        for notes in notes {
            self.tracker.proxies.notes.append(notes);
        }
        unusual
    }

    /// Sets one box, whatever has changed.
    fn set_box<H: Handle>(&mut self, handle: H, aabb: Aabb<R, D>, margin: R) {
        let Some(slot) = self.slot_of(handle) else {
            return self.keep_pending(handle, aabb);
        };
        let key = self.tracker.proxies.key(slot);
        self.admit(handle, margin, |_| {
            Some(Reading {
                aabb,
                key,
                has_only_moved: true,
                is_skipped: false,
            })
        });
    }

    /// Has the next update read an unknown collider, and shows its box to queries until then. If the slot has a later generation, the
    /// collider is gone, and its box is ignored.
    #[cold]
    fn keep_pending(&mut self, handle: impl Handle, aabb: Aabb<R, D>) {
        let (slot, generation) = handle.into_raw_parts();
        let index = slot as usize;
        if self.generations.get(index).copied().flatten() > Some(generation) {
            return;
        }
        // Memory grows with the highest slot, so a collider that may not exist gets no slot far beyond all known ones.
        if index < self.known_slots + ROOM_AHEAD {
            self.make_room(index + 1);
            let known = self.generations[index];
            if let Some(known) = known {
                // It is probably gone, and its removal not reported yet. If not, the next update reads it.
                self.pending.insert((slot, known));
            }
            if aabb.is_valid() {
                self.place(slot, aabb);
            } else if known.is_none() {
                self.tracker.proxies.clear_box(slot);
            }
        }
        self.pending.insert((slot, generation));
    }

    /// Reads the pending colliders, except those that have been removed since.
    pub(super) fn admit_pending<S>(&mut self, removed: &[S::Handle], source: &S, margin: R)
    where
        S: ColliderSource<R, D, Memo = M, Key = K>,
    {
        let mut pending = std::mem::take(&mut self.pending);
        for &(slot, _) in &pending {
            if self.generations.get(slot as usize) == Some(&None) {
                // The box was only there for queries.
                self.tracker.proxies.clear_box(slot);
            }
        }
        for handle in removed {
            pending.remove(&handle.into_raw_parts());
        }
        for (slot, generation) in pending {
            self.admit_read(S::Handle::from_raw_parts(slot, generation), source, margin);
        }
    }
}
