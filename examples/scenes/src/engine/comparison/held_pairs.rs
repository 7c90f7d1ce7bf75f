//! The pairs that two broad phases hold, as told by their events.

use super::World;
use super::both::{Both, Side};
use super::pair::Pair;
use super::rapier::prelude::*;
use std::collections::HashSet;

/// The pairs that two broad phases hold.
#[derive(Default)]
pub(super) struct HeldPairs(Both<HashSet<Pair>>);

impl HeldPairs {
    /// Whether this side holds the pair.
    pub(super) fn holds(&self, side: Side, pair: Pair) -> bool {
        self.0[side].contains(&pair)
    }

    /// How many pairs this side holds.
    pub(super) fn count(&self, side: Side) -> usize {
        self.0[side].len()
    }

    /// How many of them the narrow phase does not drop.
    pub(super) fn count_relevant(&self, side: Side, world: &World) -> usize {
        let is_relevant = |pair: &&Pair| !pair.is_dropped_by_narrow_phase(world);
        self.0[side].iter().filter(is_relevant).count()
    }

    /// Notes that this side has reported the pair as new (`held`) or as ended. False if it was so before,
    /// that is, if the event was redundant.
    pub(super) fn set(&mut self, side: Side, pair: Pair, held: bool) -> bool {
        if held {
            self.0[side].insert(pair)
        } else {
            self.0[side].remove(&pair)
        }
    }

    /// Drops every pair of a removed or disabled collider, as the narrow phase does without being told.
    pub(super) fn remove(&mut self, removed: &[ColliderHandle]) {
        if removed.is_empty() {
            return;
        }
        let removed: HashSet<_> = removed.iter().copied().collect();
        for side in [Side::Default, Side::Candidate] {
            self.0[side].retain(|pair| pair.handles().iter().all(|end| !removed.contains(end)));
        }
    }

    /// The first pair that one side holds and the other does not, with the side that holds it, and how many
    /// there are; those that the narrow phase drops anyway are left out, and those of the default if the candidate may hold
    /// fewer.
    pub(super) fn difference(&self, world: &World, fewer: bool) -> Option<(Side, Pair, usize)> {
        let only = |side: Side| {
            let pairs = self.0[side].difference(&self.0[side.other()]).copied();
            pairs.filter(|pair| !pair.is_dropped_by_narrow_phase(world))
        };
        let of_default = only(Side::Default).filter(|_| !fewer);
        let all = of_default.map(|pair| (pair, Side::Default));
        let all = all.chain(only(Side::Candidate).map(|pair| (pair, Side::Candidate)));
        let count = all.clone().count();
        // In an order that does not depend on hashing.
        let (pair, side) = all.min_by_key(|&(pair, _)| pair)?;
        Some((side, pair, count))
    }

    /// How the candidate's own list of what it holds differs from what its events say, if it does.
    pub(super) fn check_list(&self, list: &[ColliderPair]) -> Option<String> {
        let mut listed = HashSet::with_capacity(list.len());
        for pair in list.iter().map(|&pair| Pair::from(pair)) {
            if !listed.insert(pair) {
                return Some(format!("the candidate lists the pair {pair} twice"));
            }
            if !self.holds(Side::Candidate, pair) {
                return Some(format!(
                    "the candidate lists the pair {pair}, which it never reported or has ended"
                ));
            }
        }
        let missing = self.0.candidate.difference(&listed).min()?;
        Some(format!(
            "the candidate has reported the pair {missing} and does not list it"
        ))
    }
}
