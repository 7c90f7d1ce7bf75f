//! Whether a tracker is consistent, and its pairs are those of a full search.

use std::collections::HashSet;

use super::{FilterKey, PairTracker, overlapping};
use crate::slot_set::SlotSet;
use crate::{Kernel, Real};

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
        // Volumes that have changed since the last `finish` say nothing about it.
        let mut are_pending = touched;
        let stirred = self.stirred.iter();
        stirred.for_each(|&slot| are_pending.insert(slot));
        let should_be_held = |pair: [u32; 2], is_held: bool| {
            let is_pending = pair.iter().any(|&slot| are_pending.contains(slot));
            match self.volumes.are_used() {
                false => true,
                true if is_pending => is_held,
                true => is_held || self.volumes.meet(pair, R::ZERO),
            }
        };
        self.candidates.validate(previous, should_be_held);
        let check = |kept: Vec<[u32; 2]>, mut expected: Vec<[u32; 2]>, what: &str| {
            let mut kept = kept;
            kept.sort_unstable();
            expected.sort_unstable();
            assert!(kept == expected, "{what} are not the overlapping ones");
        };
        let held: HashSet<_> = self.pairs().collect();
        let mut expected = overlapping(kernel, previous, keys);
        expected.retain(|pair| should_be_held(*pair, held.contains(pair)));
        check(self.pairs().collect(), expected, "the held pairs");
        check(
            self.candidates.iter().collect(),
            overlapping(kernel, fat_boxes, keys),
            "the candidates",
        );
    }
}
