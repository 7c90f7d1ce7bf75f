//! Whether a tracker is consistent, and its pairs are those of a full search.

use super::{FilterKey, PairTracker, overlapping};
use crate::slot_set::SlotSet;
use crate::{Aabb, Kernel, Real};

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// Panics unless the pairs held since the last `finish` are exactly those that overlapped then, by a full run of a
    /// kernel, and everything else that is kept is consistent.
    pub(crate) fn validate(&self, kernel: Kernel) {
        let Self {
            boxes,
            previous,
            fat_boxes,
            keys,
            ..
        } = self;
        assert_eq!(boxes.len(), previous.len());
        assert_eq!(boxes.len(), fat_boxes.len());
        assert_eq!(boxes.len(), keys.len());
        assert!(self.former_keys.is_empty());
        for (slot, (before, fat)) in previous.iter().zip(fat_boxes).enumerate() {
            let is_inside = fat.contains(before) || !(before.is_valid() || fat.is_valid());
            assert!(is_inside, "the box of slot {slot} is not in its fat box");
        }
        let mut touched = SlotSet::default();
        touched.make_room(boxes.len());
        self.touched.iter().for_each(|&slot| touched.insert(slot));
        for slot in 0..boxes.len() as u32 {
            let i = slot as usize;
            let is_settled =
                boxes[i] == previous[i] || !(boxes[i].is_valid() || previous[i].is_valid());
            assert!(
                is_settled || touched.contains(slot),
                "the box of slot {slot} is not settled"
            );
            assert!(
                is_settled || fat_boxes[i].contains(&boxes[i]) || self.escaped.contains(slot),
                "slot {slot} has escaped unnoticed"
            );
        }
        let is_touched = |&slot: &u32| touched.contains(slot);
        assert!(self.escaped.slots().iter().all(is_touched));
        self.candidates.validate(previous);
        let check = |mut kept: Vec<_>, boxes: &[Aabb<R, D>], what: &str| {
            let mut expected = overlapping(kernel, boxes, keys);
            kept.sort_unstable();
            expected.sort_unstable();
            assert!(kept == expected, "{what} are not the overlapping ones");
        };
        check(self.pairs().collect(), previous, "the held pairs");
        check(
            self.candidates.iter().collect(),
            fat_boxes,
            "the candidates",
        );
    }
}
