//! Places and moves many proxies, one after the other.
//!
//! A mover borrows only what a move writes, so the caller goes on reading the rest of its tables.

use super::VolumesPart;
use crate::slot_set::SlotSet;
use crate::volume::Volume;
use crate::{Aabb, Real};

/// Places and moves proxies in slots for which there is room.
pub(crate) struct Mover<'a, R, const D: usize> {
    pub(super) boxes: &'a mut [Aabb<R, D>],
    pub(super) fat_boxes: &'a [Aabb<R, D>],
    pub(super) touched: &'a mut Vec<u32>,
    pub(super) escaped: &'a mut SlotSet,
    pub(super) volumes: VolumesPart<'a, R, D>,
    pub(super) stirred: &'a mut Vec<u32>,
}

impl<R: Real, const D: usize> Mover<'_, R, D> {
    /// The box under a slot; all NaN if there is no proxy.
    #[inline(always)]
    pub(crate) fn held(&self, slot: u32) -> &Aabb<R, D> {
        &self.boxes[slot as usize]
    }

    /// The volumes of all slots.
    #[inline(always)]
    pub(crate) fn volumes(&self) -> &VolumesPart<'_, R, D> {
        &self.volumes
    }

    /// Moves the ball of a slot, whose volume must be one, into a box, by which its own `is_renewed` or not.
    #[inline(always)]
    pub(crate) fn stir_ball(&mut self, slot: u32, aabb: &Aabb<R, D>, is_renewed: bool) {
        // What has another box is compared for that.
        if self.volumes.set_ball_in(slot as usize, aabb, is_renewed) && !is_renewed {
            self.stirred.push(slot);
        }
    }

    /// Moves the volume of a slot, whose kind must be the same as before, and whose box `is_renewed` or not.
    #[inline(always)]
    pub(crate) fn stir(&mut self, slot: u32, volume: &Volume<R, D>, is_renewed: bool) {
        if self.volumes.set(slot as usize, volume, is_renewed) && !is_renewed {
            self.stirred.push(slot);
        }
    }

    /// Places or moves the proxy of a slot. `aabb` must be valid.
    #[inline(always)]
    pub(crate) fn place(&mut self, slot: u32, aabb: Aabb<R, D>) {
        debug_assert!(aabb.is_valid());
        let index = slot as usize;
        self.boxes[index] = aabb;
        self.touched.push(slot);
        if !self.fat_boxes[index].contains(&aabb) {
            self.escaped.insert(slot);
        }
    }
}
