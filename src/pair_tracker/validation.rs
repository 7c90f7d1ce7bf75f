//! Checks that a tracker is consistent, and that its pairs are those of a full search.

use super::{FilterKey, PairTracker};
use crate::aabb::Aabb;
use crate::pair_finder::PairFinder;
use crate::real::Real;
use crate::slot_set::SlotSet;

impl<R: Real, const D: usize, K: FilterKey> PairTracker<R, D, K> {
    /// Panics unless the pairs held since the last update are exactly those that overlapped then, as found by this kernel, and all other
    /// state is consistent.
    pub(crate) fn validate(&self, finder: &mut impl PairFinder<R, D>) {
        let proxies = &self.proxies;
        let slots = proxies.boxes.len();
        let lengths = [&proxies.previous, &proxies.fat_boxes].map(Vec::len);
        assert_eq!([lengths[0], lengths[1], proxies.keys.len()], [slots; 3]);
        let notes = &proxies.notes;
        let [touched, leavers] = [&notes.touched, &notes.leavers].map(|list| SlotSet::of(list));
        for slot in 0..slots as u32 {
            let all = [&proxies.boxes, &proxies.previous, &proxies.fat_boxes];
            let [now, before, fat] = all.map(|boxes| &boxes[slot as usize]);
            assert!(
                fat.contains(before) || !(before.is_valid() || fat.is_valid()),
                "the box of slot {slot} is not in its fat box"
            );
            assert!(touched.contains(slot) || !leavers.contains(slot));
            if now != before && (now.is_valid() || before.is_valid()) {
                assert!(touched.contains(slot), "slot {slot} has moved unnoticed");
                assert!(
                    fat.contains(now) || leavers.contains(slot),
                    "slot {slot} has left its fat box unnoticed"
                );
            }
        }
        // Volumes that have changed since the last update say nothing about it.
        let are_noted = SlotSet::of(&[&notes.touched[..], &notes.revolumed].concat());
        let should_be_held = |pair: [u32; 2], is_held: bool| {
            let meet = || !are_noted.has_any(pair) && proxies.volumes.meet(pair, R::ZERO);
            is_held || ((!proxies.volumes.are_used || meet()) && proxies.may_meet(pair))
        };
        self.candidates.validate(&proxies.previous, should_be_held);
        // All pairs that overlap are among the candidates, because fat boxes contain boxes. A candidate that its keys have come to forbid is no
        // longer searched for.
        let mut expected = overlapping(finder, &proxies.fat_boxes, &proxies.keys);
        let mut candidates = self.candidates.pairs.clone();
        if proxies.are_rekeyed {
            candidates.retain(|&pair| proxies.may_meet(pair));
        }
        candidates.sort_unstable();
        expected.sort_unstable();
        assert!(candidates == expected, "the candidates do not overlap");
    }
}

/// The overlapping pairs among the valid `boxes` that may meet, as found by a kernel.
pub(super) fn overlapping<R: Real, const D: usize, K: FilterKey>(
    finder: &mut impl PairFinder<R, D>,
    boxes: &[Aabb<R, D>],
    keys: &[K],
) -> Vec<[u32; 2]> {
    let numbered = (0..).zip(boxes.iter().copied());
    let (slots, valid): (Vec<u32>, Vec<_>) = numbered.filter(|(_, aabb)| aabb.is_valid()).unzip();
    let mut found = Vec::new();
    // They are valid, and no more than any kernel takes.
    let _ = finder.find_pairs(&valid, &mut found);
    // Slots ascend, so the smaller one of a pair stays the smaller one.
    for pair in &mut found {
        *pair = pair.map(|i| slots[i as usize]);
    }
    found.retain(|&[a, b]| keys[a as usize].may_meet(keys[b as usize]));
    found
}
