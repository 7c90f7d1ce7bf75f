//! Reading colliders on several threads.
//!
//! Slots are cut into parts of consecutive ones, and each thread reads the listed colliders of a part: that is most of
//! the work of an update in which much is listed, and each collider is read by itself. What is not a simple move, say a
//! collider that is new, is left to be done afterwards, and everything is put together in the order of the slots.

use super::outline::Outline;
use super::rapier::geometry::ColliderHandle;
use super::rapier::math::{DIM, Real};
use super::world::World;
use crate::Aabb;

/// Fewer listed colliders than this are not worth a second thread.
pub(super) const WORTH_A_THREAD: usize = 1 << 14;

/// What has come of reading a part, by slots in ascending order. Its memory is kept between updates.
#[derive(Clone, Debug, Default)]
pub(super) struct Findings {
    /// Those whose proxy was moved.
    pub(super) moved: Vec<u32>,
    /// Those of them that have left their reach.
    pub(super) escaped: Vec<u32>,
    /// Those that need a second look.
    pub(super) left: Vec<u32>,
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
    pub(super) findings: &'a mut Findings,
}

impl ReadingPart<'_> {
    /// Reads the listed colliders, and lists them no longer.
    pub(super) fn read(&mut self, world: &World) {
        let Findings {
            moved,
            escaped,
            left,
        } = &mut *self.findings;
        moved.clear();
        escaped.clear();
        left.clear();
        for word in 0..self.listed.len() {
            let mut bits = std::mem::take(&mut self.listed[word]);
            while bits != 0 {
                let i = 64 * word + bits.trailing_zeros() as usize;
                bits &= bits - 1;
                // A newer collider may have taken its place since it was listed, and has been read then.
                let Some(generation) = self.generations[i] else {
                    continue;
                };
                let slot = self.first_slot + i as u32;
                let handle = ColliderHandle::from_raw_parts(slot, generation);
                let collider = world.colliders.get(handle);
                let Some(collider) = collider.filter(|collider| collider.is_enabled()) else {
                    left.push(slot);
                    continue;
                };
                let aabb = world.collider_box(collider, &mut self.outlines[i]);
                match world.renewed(&self.boxes[i], &aabb) {
                    None => {}
                    Some(None) => left.push(slot),
                    Some(Some(renewed)) => {
                        self.boxes[i] = renewed;
                        moved.push(slot);
                        if !self.reaches[i].contains(&renewed) {
                            escaped.push(slot);
                        }
                    }
                }
            }
        }
    }
}
