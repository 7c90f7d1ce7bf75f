//! Inflates boxes to fat boxes anew: of what has left its own, of what was touched, or of all.

use super::FilterKey;
use super::foresight::Foresight;
use super::policy::are_most_touched;
use super::proxies::{Proxies, slots_a_task};
use crate::aabb::Aabb;
use crate::parallel;
use crate::real::Real;

impl<R: Real, const D: usize, K: FilterKey> Proxies<R, D, K> {
    /// Inflates the boxes that have left their fat boxes.
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
        let slots = slots_a_task(self.boxes.len());
        let boxes = self.boxes.chunks(slots).zip(self.previous.chunks(slots));
        let mut parts: Vec<_> = self.fat_boxes.chunks_mut(slots).zip(boxes).collect();
        parallel::for_each(&mut parts, |(fat_boxes, (boxes, previous))| {
            for (fat, (now, before)) in fat_boxes.iter_mut().zip(boxes.iter().zip(*previous)) {
                if is_due(fat, now, before) {
                    *fat = foresight.fat_box(now, before);
                }
            }
        });
    }
}
