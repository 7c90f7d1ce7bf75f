//! The pairs that two broad phases hold, as told by their events.
//!
//! Both are kept in one map, and the pairs that only one of them holds in a small set beside it, so that checking
//! whether they agree costs nothing as long as they do.

use super::World;
use super::both::{Both, Side};
use super::pair::Pair;
use super::rapier::prelude::*;
use std::collections::{BTreeSet, HashMap, HashSet};

/// Who holds a pair.
#[derive(Clone, Copy, Default)]
struct Holders {
    held: Both<bool>,
    /// The last check of the candidate's own list in which the pair was found.
    listed: u32,
}

/// The pairs that two broad phases hold.
#[derive(Default)]
pub(super) struct HeldPairs {
    holders: HashMap<Pair, Holders>,
    /// The pairs with one holder only, in an order that does not depend on hashing.
    uneven: BTreeSet<Pair>,
    counts: Both<usize>,
    looks: u32,
}

impl HeldPairs {
    /// Whether this side holds the pair.
    pub(super) fn holds(&self, side: Side, pair: Pair) -> bool {
        self.holders
            .get(&pair)
            .is_some_and(|holders| holders.held[side])
    }

    /// How many pairs this side holds.
    pub(super) fn count(&self, side: Side) -> usize {
        self.counts[side]
    }

    /// How many of them the narrow phase does not drop.
    pub(super) fn count_relevant(&self, side: Side, world: &World) -> usize {
        self.holders
            .iter()
            .filter(|(pair, holders)| holders.held[side] && !pair.is_dropped_by_narrow_phase(world))
            .count()
    }

    /// Notes that this side has reported the pair as new (`held`) or as ended. False if it was so before,
    /// that is, if the event was redundant.
    pub(super) fn set(&mut self, side: Side, pair: Pair, held: bool) -> bool {
        let holders = self.holders.entry(pair).or_default();
        let new = holders.held[side] != held;
        holders.held[side] = held;
        let held_by = holders.held;
        if held_by == Both::default() {
            self.holders.remove(&pair);
        }
        if new {
            if held {
                self.counts[side] += 1;
            } else {
                self.counts[side] -= 1;
            }
            if held_by.default == held_by.candidate {
                self.uneven.remove(&pair);
            } else {
                self.uneven.insert(pair);
            }
        }
        new
    }

    /// Drops every pair of a removed or disabled collider, as the narrow phase does without being told.
    pub(super) fn remove(&mut self, removed: &[ColliderHandle]) {
        if removed.is_empty() {
            return;
        }
        let removed: HashSet<_> = removed.iter().collect();
        let stays = |pair: &Pair| {
            pair.handles()
                .iter()
                .all(|handle| !removed.contains(handle))
        };
        let counts = &mut self.counts;
        self.holders.retain(|pair, holders| {
            let stays = stays(pair);
            for side in [Side::Default, Side::Candidate] {
                counts[side] -= usize::from(!stays && holders.held[side]);
            }
            stays
        });
        self.uneven.retain(stays);
    }

    /// The first pair that one side holds and the other does not, with the side that holds it, and how many
    /// there are; those that the narrow phase drops anyway are left out, and those of the default if the candidate may hold
    /// fewer.
    pub(super) fn difference(&self, world: &World, fewer: bool) -> Option<(Side, Pair, usize)> {
        let mut differences = self.uneven.iter().filter(|&&pair| {
            let may_be_missing = fewer && self.holds(Side::Default, pair);
            !(may_be_missing || pair.is_dropped_by_narrow_phase(world))
        });
        let &pair = differences.next()?;
        let side = if self.holds(Side::Default, pair) {
            Side::Default
        } else {
            Side::Candidate
        };
        Some((side, pair, 1 + differences.count()))
    }

    /// How the candidate's own list of what it holds differs from what its events say, if it does.
    pub(super) fn check_list(&mut self, list: &[ColliderPair]) -> Option<String> {
        self.looks += 1;
        for &listed in list {
            let pair = Pair::from(listed);
            match self.holders.get_mut(&pair) {
                Some(holders) if holders.held.candidate => {
                    if holders.listed == self.looks {
                        return Some(format!("the candidate lists the pair {pair} twice"));
                    }
                    holders.listed = self.looks;
                }
                _ => {
                    return Some(format!(
                        "the candidate lists the pair {pair}, which it never reported or has ended"
                    ));
                }
            }
        }
        if list.len() == self.count(Side::Candidate) {
            return None;
        }
        let missing = self
            .holders
            .iter()
            .filter(|(_, holders)| holders.held.candidate && holders.listed != self.looks)
            .map(|(pair, _)| pair)
            .min()?;
        Some(format!(
            "the candidate has reported the pair {missing} and does not list it"
        ))
    }
}
