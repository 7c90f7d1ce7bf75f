//! Which pairs are not reported: those that the narrow phase would drop.
//!
//! The rules are those of `BroadPhaseBvh::update` in Rapier 0.36. A pair that is withheld is asked for again whenever one
//! of its colliders is listed as modified, for from outside it cannot be seen what about it was.

use std::collections::BTreeSet;

use super::super::rapier::dynamics::{RigidBodySet, RigidBodyType};
use super::super::rapier::geometry::{Collider, ColliderHandle, ColliderSet};
use crate::pair_tracker::PairChange;

/// The pairs that overlap and are withheld, by slots, smaller first.
#[derive(Clone, Default)]
pub(in super::super) struct PairFilter {
    withheld: BTreeSet<[u32; 2]>,
    /// In how many of them each slot occurs; slots at the end that occur in none may be missing.
    counts: Vec<u32>,
}

impl PairFilter {
    /// The pairs that are withheld, ascending.
    #[cfg(feature = "serde-serialize")]
    pub(in super::super) fn pairs(&self) -> Vec<[u32; 2]> {
        self.withheld.iter().copied().collect()
    }

    /// Withholds these pairs, which must be among those that overlap.
    #[cfg(feature = "serde-serialize")]
    pub(in super::super) fn restore(
        withheld: Vec<[u32; 2]>,
        overlapping: impl Iterator<Item = [u32; 2]>,
    ) -> Result<Self, &'static str> {
        let overlapping: BTreeSet<_> = overlapping.collect();
        let mut restored = Self::default();
        for pair in withheld {
            if !overlapping.contains(&pair) {
                return Err("snapshot: a pair is withheld that does not overlap");
            }
            restored.withhold(pair);
        }
        Ok(restored)
    }

    /// Leaves those of these changes that are to be reported, and adds the pairs withheld before that are allowed now.
    /// **O(changes)**; if any were withheld **O(listed)** more, and **O(withheld)** if one of the listed occurs among them.
    pub(in super::super) fn sift(
        &mut self,
        changes: &mut Vec<PairChange>,
        listed: &[ColliderHandle],
        removed: &[u32],
        generations: &[Option<u32>],
        colliders: &ColliderSet,
        bodies: &RigidBodySet,
    ) {
        let allows = |pair: [u32; 2]| {
            let [first, second] = pair.map(|slot| {
                let generation = generations[slot as usize]?;
                colliders.get(ColliderHandle::from_raw_parts(slot, generation))
            });
            first
                .zip(second)
                .is_some_and(|(first, second)| may_meet(first, second, bodies))
        };
        self.forget(removed);
        let known = |handle: &ColliderHandle| {
            let (slot, generation) = handle.into_raw_parts();
            (generations.get(slot as usize) == Some(&Some(generation))).then_some(slot)
        };
        let listed = if self.withheld.is_empty() {
            &[]
        } else {
            listed
        };
        let listed = listed.iter().filter_map(known);
        let mut is_again: Vec<_> = listed.filter(|&slot| self.count(slot) > 0).collect();
        changes.retain(|change| match *change {
            PairChange::Added(pair) => {
                let is_allowed = allows(pair);
                if !is_allowed {
                    self.withhold(pair);
                }
                is_allowed
            }
            PairChange::Deleted(pair) => !self.release(pair),
        });
        if is_again.is_empty() {
            return;
        }
        is_again.sort_unstable();
        let is_again = |slot: &u32| is_again.binary_search(slot).is_ok();
        let candidates = self
            .withheld
            .iter()
            .filter(|pair| pair.iter().any(is_again));
        let allowed: Vec<_> = candidates.copied().filter(|&pair| allows(pair)).collect();
        for pair in allowed {
            self.release(pair);
            changes.push(PairChange::Added(pair));
        }
    }

    /// Whether this pair overlaps and is not to be known.
    pub(in super::super) fn withholds(&self, pair: [u32; 2]) -> bool {
        self.withheld.contains(&pair)
    }

    /// The number of pairs that are withheld.
    pub(in super::super) fn withheld(&self) -> usize {
        self.withheld.len()
    }

    /// Panics unless the withheld pairs are among those that overlap, and are counted.
    pub(in super::super) fn validate(&self, pairs: impl Iterator<Item = [u32; 2]>) {
        let overlapping: BTreeSet<_> = pairs.collect();
        assert!(self.withheld.is_subset(&overlapping));
        let mut counts = vec![0; self.counts.len()];
        for slot in self.withheld.iter().flatten() {
            counts[*slot as usize] += 1;
        }
        assert_eq!(self.counts, counts);
    }

    fn count(&self, slot: u32) -> u32 {
        self.counts.get(slot as usize).copied().unwrap_or(0)
    }

    fn withhold(&mut self, pair: [u32; 2]) {
        if self.withheld.insert(pair) {
            for slot in pair.map(|slot| slot as usize) {
                if slot >= self.counts.len() {
                    self.counts.resize(slot + 1, 0);
                }
                self.counts[slot] += 1;
            }
        }
    }

    /// Withholds a pair no longer. Whether it was withheld.
    fn release(&mut self, pair: [u32; 2]) -> bool {
        let was_withheld = self.withheld.remove(&pair);
        if was_withheld {
            for slot in pair {
                self.counts[slot as usize] -= 1;
            }
        }
        was_withheld
    }

    /// Drops the pairs of slots whose collider was removed.
    fn forget(&mut self, removed: &[u32]) {
        let slots = removed.iter().copied();
        let mut slots: Vec<_> = slots.filter(|&slot| self.count(slot) > 0).collect();
        if slots.is_empty() {
            return;
        }
        slots.sort_unstable();
        let is_removed = |slot: &u32| slots.binary_search(slot).is_ok();
        let pairs = self
            .withheld
            .iter()
            .filter(|pair| pair.iter().any(is_removed));
        for pair in pairs.copied().collect::<Vec<_>>() {
            self.release(pair);
        }
    }
}

/// Whether the narrow phase would look at these two.
fn may_meet(first: &Collider, second: &Collider, bodies: &RigidBodySet) -> bool {
    if first.parent().is_some() && first.parent() == second.parent() {
        return false;
    }
    let [first_type, second_type] = [first, second].map(|collider| {
        let body = collider.parent().and_then(|parent| bodies.get(parent));
        body.map_or(RigidBodyType::Fixed, |body| body.body_type())
    });
    let types_meet =
        |types: &Collider| types.active_collision_types().test(first_type, second_type);
    (types_meet(first) || types_meet(second))
        && first.collision_groups().test(second.collision_groups())
}
