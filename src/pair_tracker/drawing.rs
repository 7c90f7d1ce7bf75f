//! Draws fat boxes anew: of what has escaped, of what was touched, or of all.

use super::policy::are_most_touched;
use super::{FilterKey, PairTracker};
use crate::tuning::update::{SLOTS_A_TASK, THREADS_FROM};
use crate::{Aabb, Real, parallel};

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// Draws the fat boxes of the escaped.
    pub(super) fn draw_escaped(&mut self) {
        let horizon = self.foresight.horizon();
        for &slot in self.escaped.slots() {
            let i = slot as usize;
            self.fat_boxes[i] = horizon.fat_box(&self.boxes[i], &self.previous[i]);
        }
    }

    /// Draws the fat boxes of what was touched.
    pub(super) fn draw_touched(&mut self) {
        let Self {
            boxes,
            previous,
            fat_boxes,
            foresight,
            ..
        } = self;
        let horizon = foresight.horizon();
        if !are_most_touched(self.touched.len(), boxes.len()) {
            for &slot in &self.touched {
                let i = slot as usize;
                fat_boxes[i] = horizon.fat_box(&boxes[i], &previous[i]);
            }
            return;
        }
        let draw = |fat_boxes: &mut [Aabb<R, D>], boxes: &[_], previous: &[_]| {
            for (fat, (now, before)) in fat_boxes.iter_mut().zip(boxes.iter().zip(previous)) {
                // The rest has not moved, or is back inside its fat box.
                if now != before || !fat.contains(now) {
                    *fat = horizon.fat_box(now, before);
                }
            }
        };
        if boxes.len() < THREADS_FROM {
            return draw(fat_boxes, boxes, previous);
        }
        let boxes = boxes
            .chunks(SLOTS_A_TASK)
            .zip(previous.chunks(SLOTS_A_TASK));
        let mut parts: Vec<_> = fat_boxes.chunks_mut(SLOTS_A_TASK).zip(boxes).collect();
        parallel::for_each(&mut parts, |(fat_boxes, (boxes, previous))| {
            draw(fat_boxes, boxes, previous);
        });
    }

    /// Draws all fat boxes.
    pub(super) fn draw_all(&mut self) {
        let horizon = self.foresight.horizon();
        let boxes = self.boxes.iter().zip(&self.previous);
        for (fat, (now, before)) in self.fat_boxes.iter_mut().zip(boxes) {
            *fat = horizon.fat_box(now, before);
        }
    }
}
