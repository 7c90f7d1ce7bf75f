//! Reading colliders on several threads.
//!
//! Slots are cut into parts of consecutive ones, and each thread reads the listed colliders of a part: that is most of
//! the work of an update in which much is listed, and each collider is read by itself. What is not a simple move, say a
//! collider that is new, is left to be done afterwards, and everything is put together in the order of the slots.

use super::broad_phase::World;
use super::outline::Outline;
use super::rapier::geometry::ColliderHandle;
use super::rapier::math::{DIM, Real};
use crate::Aabb;
use crate::pair_tracker::Placed;

/// Fewer listed colliders than this are not worth a second thread.
pub(super) const WORTH_A_THREAD: usize = 1 << 12;

/// What has come of a slot that was read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    /// Its proxy was moved.
    Placed(Placed),
    /// It needs a second look.
    Left,
}

/// A part of the slots, and what is kept under them.
pub(super) struct ReadingPart<'a> {
    pub(super) first_slot: u32,
    /// The listed ones: a bit for each slot.
    pub(super) listed: &'a mut [u64],
    pub(super) generations: &'a [Option<u32>],
    pub(super) outlines: &'a mut [Outline],
    pub(super) boxes: &'a mut [Aabb<Real, DIM>],
    pub(super) reaches: &'a [Aabb<Real, DIM>],
    /// The slots of which there is something to tell, in order.
    pub(super) outcomes: Vec<(u32, Outcome)>,
}

impl ReadingPart<'_> {
    /// Reads the listed colliders, and lists them no longer.
    pub(super) fn read(&mut self, world: &World) {
        for word in 0..self.listed.len() {
            let mut bits = std::mem::take(&mut self.listed[word]);
            while bits != 0 {
                let i = 64 * word + bits.trailing_zeros() as usize;
                bits &= bits - 1;
                if let Some(outcome) = self.read_one(i, world) {
                    self.outcomes.push((self.first_slot + i as u32, outcome));
                }
            }
        }
    }

    #[inline(always)]
    fn read_one(&mut self, i: usize, world: &World) -> Option<Outcome> {
        let handle =
            ColliderHandle::from_raw_parts(self.first_slot + i as u32, self.generations[i]?);
        let Some(collider) = world.colliders.get(handle).filter(|co| co.is_enabled()) else {
            return Some(Outcome::Left);
        };
        let aabb = world.collider_box(collider, &mut self.outlines[i]);
        match world.renewed(&self.boxes[i], &aabb)? {
            Some(renewed) => {
                self.boxes[i] = renewed;
                let is_escaped = !self.reaches[i].contains(&renewed);
                Some(Outcome::Placed(Placed { is_escaped }))
            }
            None => Some(Outcome::Left),
        }
    }
}
