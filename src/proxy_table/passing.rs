//! Boxes that the engine passes between two updates, because it has computed them already.
//!
//! They count in the next update. The table does not read a known collider again, and nearly all boxes are moves of known colliders, which
//! one tight loop applies.
//!
//! Only the next update can tell whether an unknown collider exists and what it may meet, so that update reads it, except its box. Until then
//! its slot has the passed box, for queries.

use std::collections::{BTreeMap, BTreeSet};

use super::{ColliderSource, Handle, Memo, ProxyTable, Reading, is_known};
use crate::aabb::Aabb;
use crate::pair_tracker::FilterKey;
use crate::parallel::Section;
use crate::real::Real;
use crate::tuning::update::{MOST_NOTES_A_SLOT, ROOM_AHEAD};

/// A slot and a generation.
pub(super) type Id = (u32, u32);

/// The colliders that the next update reads if they exist, and the valid boxes that were passed for them.
pub(super) type Pending<R, const D: usize> = BTreeMap<Id, Option<Aabb<R, D>>>;

impl<R: Real, const D: usize, M: Memo, K: FilterKey> ProxyTable<R, D, M, K> {
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
        let most = MOST_NOTES_A_SLOT * self.generations.len();
        self.tracker.proxies.notes.forget_repeats(most);
        let first_touched = self.touched().len();
        if let &[(handle, aabb)] = boxes {
            self.set_box(handle, aabb.into(), margin);
        } else {
            let section = self.reading_section(boxes.len());
            for place in self.follow(section, boxes, margin) {
                let (handle, aabb) = boxes[place];
                self.set_box(handle, aabb.into(), margin);
            }
        }
        &self.touched()[first_touched..]
    }

    /// Moves proxies in parts, each of which goes through all boxes for those of its slots. Returns the ascending indices of the boxes that it
    /// has not applied: those that need more than a move, and later ones of the same slots, so that the boxes of a collider are applied in order.
    fn follow<H: Handle, B: Copy + Into<Aabb<R, D>> + Sync>(
        &mut self,
        section: Section,
        boxes: &[(H, B)],
        margin: R,
    ) -> Vec<usize> {
        // At least one, so that there is a part.
        self.make_room(1);
        let room = self.generations.len();
        let slots = room.div_ceil(section.parts());
        let starts = (0..room).step_by(slots);
        let ranges = starts.map(|start| match start + slots < room {
            true => start..start + slots,
            // Those of slots without room need more than a move.
            false => start..usize::MAX,
        });
        let mut unusual = self.for_chunks(section, slots, ranges, |range, chunk| {
            let (proxies, (generations, _)) = chunk;
            let (mut unusual, mut slots) = (Vec::new(), BTreeSet::new());
            for (place, &(handle, aabb)) in boxes.iter().enumerate() {
                let (slot, generation) = handle.into_raw_parts();
                if !range.contains(&(slot as usize)) {
                    continue;
                }
                let (i, aabb): (_, Aabb<R, D>) = (slot as usize - range.start, aabb.into());
                if !slots.contains(&slot) && is_known(generations, i as u32, generation) {
                    proxies.follow_volume(i, &aabb, true);
                    if proxies.follow(i, &aabb, margin) {
                        continue;
                    }
                }
                slots.insert(slot);
                unusual.push(place);
            }
            unusual
        });
        unusual.sort_unstable();
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
            if aabb.is_valid() {
                self.place(slot, aabb);
                // It is probably gone, and its removal not reported yet. If not, the next update reads it.
                self.pending.extend(known.map(|old| ((slot, old), None)));
            } else if known.is_none() {
                self.tracker.proxies.clear_box(slot);
            }
        }
        self.pending
            .insert((slot, generation), Some(aabb).filter(Aabb::is_valid));
    }

    /// Reads the pending colliders, except those that have been removed since.
    pub(super) fn admit_pending<S>(&mut self, removed: &[S::Handle], source: &S, margin: R)
    where
        S: ColliderSource<R, D, Memo = M, Key = K>,
    {
        let mut pending = std::mem::take(&mut self.pending);
        for &(slot, generation) in pending.keys() {
            let known = self.generations.get(slot as usize);
            if known.is_some_and(|known| known.is_none_or(|known| known == generation)) {
                self.clear_box(slot);
            }
        }
        for handle in removed {
            pending.remove(&handle.into_raw_parts());
        }
        for ((slot, generation), aabb) in pending {
            let handle = S::Handle::from_raw_parts(slot, generation);
            self.admit(handle, margin, |memo| {
                let mut reading = source.read(handle, memo)?;
                reading.is_skipped &= aabb.is_none();
                reading.aabb = aabb.unwrap_or(reading.aabb);
                Some(reading)
            });
        }
    }
}
