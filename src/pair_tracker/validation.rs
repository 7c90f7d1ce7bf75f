//! Whether a tracker is consistent, and its pairs are those of a full search.

use std::collections::HashSet;

use super::layers::Layers;
use super::{FilterKey, PairTracker};
use crate::aabb::Aabb;
use crate::kernel::Kernel;
use crate::pair_finder::retain_from;
use crate::real::Real;
use crate::slot_set::SlotSet;
use crate::stopwatch::Stopwatch;

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// Panics unless the pairs held since the last `finish` are exactly those that overlapped then, by a full search of a
    /// kernel, and everything else that is kept is consistent.
    pub(crate) fn validate(&self, kernel: Kernel) {
        let proxies = &self.proxies;
        let slots = proxies.boxes.len();
        let lengths = [&proxies.previous, &proxies.fat_boxes].map(Vec::len);
        assert_eq!([lengths[0], lengths[1], proxies.keys.len()], [slots; 3]);
        let notes = &proxies.notes;
        let touched = set_of(&notes.touched, slots);
        let left = set_of(&notes.left, slots);
        for slot in 0..slots as u32 {
            let all = [&proxies.boxes, &proxies.previous, &proxies.fat_boxes];
            let [now, before, fat] = all.map(|boxes| &boxes[slot as usize]);
            assert!(
                fat.contains(before) || !(before.is_valid() || fat.is_valid()),
                "the box of slot {slot} is not in its fat box"
            );
            assert!(touched.contains(slot) || !left.contains(slot));
            if now != before && (now.is_valid() || before.is_valid()) {
                assert!(touched.contains(slot), "slot {slot} has moved unnoticed");
                assert!(
                    fat.contains(now) || left.contains(slot),
                    "slot {slot} has left its fat box unnoticed"
                );
            }
        }
        // Volumes that have changed since the last `finish` say nothing about it.
        let mut are_noted = touched;
        notes
            .revolumed
            .iter()
            .for_each(|&slot| are_noted.insert(slot));
        let should_be_held = |pair: [u32; 2], is_held: bool| {
            let is_noted = pair.iter().any(|&slot| are_noted.contains(slot));
            let volumes_meet = match proxies.volumes.are_used() {
                true => !is_noted && proxies.volumes.meet(pair, R::ZERO),
                false => true,
            };
            is_held || (volumes_meet && proxies.may_meet(pair))
        };
        self.candidates.validate(&proxies.previous, should_be_held);
        let check = |mut kept: Vec<[u32; 2]>, mut expected: Vec<[u32; 2]>, what: &str| {
            kept.sort_unstable();
            expected.sort_unstable();
            assert!(kept == expected, "{what} are not the overlapping ones");
        };
        // What keys have come to forbid may be held, and is no longer searched for.
        let allowed = |pair: &[u32; 2]| proxies.may_meet(*pair);
        let held: HashSet<_> = self.pairs().collect();
        let mut expected = overlapping(kernel, &proxies.previous, &proxies.keys);
        expected.retain(|pair| should_be_held(*pair, held.contains(pair)));
        check(
            self.pairs().filter(allowed).collect(),
            expected,
            "the held pairs",
        );
        let expected = overlapping(kernel, &proxies.fat_boxes, &proxies.keys);
        let mut candidates: Vec<_> = self.candidates.iter().collect();
        if proxies.are_rekeyed {
            candidates.retain(allowed);
        }
        check(candidates, expected, "the candidates");
    }
}

/// A set of slots, of so many.
pub(super) fn set_of(members: &[u32], slots: usize) -> SlotSet {
    let mut set = SlotSet::default();
    set.make_room(slots);
    members.iter().for_each(|&slot| set.insert(slot));
    set
}

/// The overlapping pairs among the valid ones of `boxes` that may meet, by a fresh kernel.
pub(super) fn overlapping<R: Real, const D: usize, K: FilterKey>(
    kernel: Kernel,
    boxes: &[Aabb<R, D>],
    keys: &[K],
) -> Vec<[u32; 2]> {
    let mut found = Vec::new();
    // Without a limit.
    let _ = Layers::new(kernel, true).find_all(
        boxes,
        None::<fn([u32; 2]) -> bool>,
        usize::MAX,
        &mut found,
        &mut Stopwatch::default(),
    );
    retain_from(&mut found, 0, |[a, b]| {
        keys[a as usize].may_meet(keys[b as usize])
    });
    found
}
