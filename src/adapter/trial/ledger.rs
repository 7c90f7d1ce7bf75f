//! Which pairs two broad phases hold, by their events.

use std::collections::{HashMap, HashSet};

use super::super::rapier::geometry::{BroadPhasePairEvent, ColliderHandle};

/// Who holds a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Own = 1,
    Unisize = 2,
}

/// The handles in order.
type Pair = [ColliderHandle; 2];

/// The pairs of both, and those that only one of them holds.
#[derive(Clone, Default)]
pub(super) struct Ledger {
    /// The sum of those who hold it.
    holders: HashMap<Pair, u8>,
    held_by_one: HashSet<Pair>,
    held_by_own: usize,
}

impl Ledger {
    /// How many pairs Rapier's own holds.
    pub(super) fn held_by_own(&self) -> usize {
        self.held_by_own
    }

    pub(super) fn held_by_one(&self) -> impl Iterator<Item = (Pair, Side)> + '_ {
        self.held_by_one.iter().map(|pair| {
            let is_own = self.holders[pair] == Side::Own as u8;
            (*pair, if is_own { Side::Own } else { Side::Unisize })
        })
    }

    /// Ends the pairs of what was removed, of which no event tells. **O(pairs)**, if anything was.
    pub(super) fn forget(&mut self, removed: &[ColliderHandle]) {
        if removed.is_empty() {
            return;
        }
        let removed: HashSet<_> = removed.iter().collect();
        let Self {
            holders,
            held_by_one,
            held_by_own,
        } = self;
        holders.retain(|pair, holders| {
            let stays = !pair.iter().any(|handle| removed.contains(handle));
            if !stays {
                held_by_one.remove(pair);
                *held_by_own -= usize::from(*holders & Side::Own as u8 != 0);
            }
            stays
        });
    }

    /// Takes the events of one side. A pair may begin that is held already, as with Rapier's own.
    pub(super) fn note(&mut self, side: Side, events: &[BroadPhasePairEvent]) {
        let side = side as u8;
        for event in events {
            let (found, is_added) = match event {
                BroadPhasePairEvent::AddPair(pair) => (pair, true),
                BroadPhasePairEvent::DeletePair(pair) => (pair, false),
            };
            let mut pair = [found.collider1, found.collider2];
            pair.sort_unstable_by_key(|handle| handle.into_raw_parts());
            let before = self.holders.get(&pair).copied().unwrap_or(0);
            let after = if is_added {
                before | side
            } else {
                before & !side
            };
            if side == Side::Own as u8 {
                self.held_by_own += usize::from(after & side != 0);
                self.held_by_own -= usize::from(before & side != 0);
            }
            match after {
                0 => self.holders.remove(&pair),
                _ => self.holders.insert(pair, after),
            };
            match after {
                1 | 2 => self.held_by_one.insert(pair),
                _ => self.held_by_one.remove(&pair),
            };
        }
    }
}
