//! A range of the proxies, written in place: that of one thread, or all of them.

use crate::aabb::Aabb;
use crate::pair_tracker::box_update::BoxUpdate;
use crate::pair_tracker::notes::Notes;
use crate::pair_tracker::volumes::{VolumeUpdate, VolumesChunk};
use crate::real::Real;
use crate::volume::Volume;

/// A range of slots, numbered from its first one.
pub(crate) struct ProxyChunk<'a, R, const D: usize, K> {
    pub(super) first_slot: usize,
    pub(super) boxes: &'a mut [Aabb<R, D>],
    pub(super) fat_boxes: &'a [Aabb<R, D>],
    pub(super) keys: &'a [K],
    pub(super) volumes: VolumesChunk<'a, R, D>,
    pub(super) notes: &'a mut Notes,
}

impl<R: Real, const D: usize, K> ProxyChunk<'_, R, D, K> {
    /// The slot at `i` of the chunk.
    #[inline(always)]
    pub(crate) fn slot(&self, i: usize) -> u32 {
        (self.first_slot + i) as u32
    }

    /// The filter key of the slot at `i`.
    #[inline(always)]
    pub(crate) fn key(&self, i: usize) -> &K {
        &self.keys[i]
    }

    /// The volume of the slot at `i` in this box, if it follows from the box.
    #[inline(always)]
    pub(crate) fn volume_by_box(&self, i: usize, aabb: &Aabb<R, D>) -> Option<Volume<R, D>> {
        self.volumes.by_box(i, aabb)
    }

    /// Places or moves the proxy at `i`. `aabb` must be valid.
    #[inline(always)]
    pub(crate) fn place(&mut self, i: usize, aabb: Aabb<R, D>) {
        debug_assert!(aabb.is_valid());
        let slot = self.slot(i);
        self.boxes[i] = aabb;
        self.notes.touched.push(slot);
        if !self.fat_boxes[i].contains(&aabb) {
            self.notes.leavers.push(slot);
        }
    }

    /// Sets the volume of the proxy at `i`, whose box stays, if volumes are in use. Returns false, and changes nothing, if the volume is of
    /// another kind.
    #[inline(always)]
    pub(crate) fn set_volume(&mut self, i: usize, volume: &Volume<R, D>) -> bool {
        if !self.volumes.are_used() {
            return true;
        }
        let update = self.volumes.set(i, volume, false);
        if update.is_some_and(VolumeUpdate::concerns_pairs) {
            let slot = self.slot(i);
            self.notes.revolumed.push(slot);
        }
        update.is_some()
    }

    /// Brings the proxy at `i` up to date with the box of its collider. If volumes are in use, `set_volume` sets the volume and returns the
    /// answer of [`VolumesChunk::set`]; its second argument says whether the box is renewed. Returns false, and changes nothing, if this
    /// is more than a move.
    #[inline(always)]
    pub(crate) fn follow(
        &mut self,
        i: usize,
        aabb: &Aabb<R, D>,
        margin: R,
        set_volume: impl FnOnce(&mut VolumesChunk<'_, R, D>, bool) -> Option<VolumeUpdate>,
    ) -> bool {
        let update = BoxUpdate::of(&self.boxes[i], aabb, margin);
        if update == BoxUpdate::Recheck {
            return false;
        }
        if self.volumes.are_used() {
            let is_renewed = update != BoxUpdate::Keep;
            let Some(update) = set_volume(&mut self.volumes, is_renewed) else {
                return false;
            };
            // The pairs of a renewed box are compared anyway.
            if update.concerns_pairs() && !is_renewed {
                let slot = self.slot(i);
                self.notes.revolumed.push(slot);
            }
        }
        if let BoxUpdate::Renew(renewed) = update {
            self.place(i, renewed);
        }
        true
    }
}
