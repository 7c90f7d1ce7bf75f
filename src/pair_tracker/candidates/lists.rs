//! Lists through the array of candidates: for each slot, the rows in which it occurs.

use super::TOMBSTONE;
use crate::pair_tracker::policy::ListState;

/// The end of a list.
const END: u32 = u32::MAX;

/// For each slot a list of its rows. They earn their keep where one in thousands moves: on the tile map in 3D, updates with lists
/// take 0.34 of the time that they take without.
///
/// A link is twice a row, plus one if the slot in question is the second one of its pair. Lists run through tombstones;
/// each walk takes those out of its own list.
#[derive(Clone, Debug, Default)]
pub(in crate::pair_tracker) struct CandidateLists {
    pub(in crate::pair_tracker) state: ListState,
    /// By slot, the first link.
    heads: Vec<u32>,
    /// By row, the link that follows for each of its two slots.
    next: Vec<[u32; 2]>,
}

impl CandidateLists {
    /// Lets them go out of date, until they are made again.
    pub(super) fn forget(&mut self) {
        self.state = ListState::default();
    }

    /// Makes the lists of this many slots.
    pub(super) fn make(&mut self, pairs: &[[u32; 2]], slots: usize) {
        self.heads.clear();
        self.next.clear();
        self.state.are_made = true;
        self.extend(pairs, 0, slots);
    }

    /// Takes in the rows from `first` on, if there are lists.
    pub(super) fn extend(&mut self, pairs: &[[u32; 2]], first: usize, slots: usize) {
        if pairs.len() > ListState::MOST_ROWS {
            self.forget();
        }
        if !self.state.are_made {
            return;
        }
        self.heads.resize(slots, END);
        for (row, &pair) in pairs.iter().enumerate().skip(first) {
            let link = 2 * row as u32;
            self.next.push(match pair {
                [TOMBSTONE, _] => [END; 2],
                pair => {
                    let [a, b] = pair.map(|slot| slot as usize);
                    let next = [self.heads[a], self.heads[b]];
                    self.heads[a] = link;
                    self.heads[b] = link + 1;
                    next
                }
            });
        }
    }

    /// Calls `visit` with each row in the list of a slot, tombstones included, and empties the list.
    pub(super) fn take(&mut self, slot: u32, mut visit: impl FnMut(usize)) {
        let Some(head) = self.heads.get_mut(slot as usize) else {
            return;
        };
        let mut link = std::mem::replace(head, END);
        while link != END {
            let (row, side) = (link as usize / 2, link as usize % 2);
            visit(row);
            link = self.next[row][side];
        }
    }

    /// Calls `visit` with each row in the list of a slot, and takes a row out of the list if `visit` returns false.
    pub(super) fn walk(&mut self, slot: u32, mut visit: impl FnMut(usize) -> bool) {
        let Some(&head) = self.heads.get(slot as usize) else {
            return;
        };
        let mut link = head;
        let mut last: Option<(usize, usize)> = None;
        while link != END {
            let (row, side) = (link as usize / 2, link as usize % 2);
            let next = self.next[row][side];
            if visit(row) {
                last = Some((row, side));
            } else {
                match last {
                    None => self.heads[slot as usize] = next,
                    Some((row, side)) => self.next[row][side] = next,
                }
            }
            link = next;
        }
    }

    /// Panics unless each candidate is in the lists of its two slots, if there are lists.
    pub(super) fn validate(&self, pairs: &[[u32; 2]]) {
        if !self.state.are_made {
            return;
        }
        let mut count = 0;
        for (slot, &head) in (0..).zip(&self.heads) {
            let mut link = head;
            while link != END {
                let (row, side) = (link as usize / 2, link as usize % 2);
                if pairs[row][0] != TOMBSTONE {
                    assert_eq!(pairs[row][side], slot, "a row in the wrong list");
                    count += 1;
                }
                link = self.next[row][side];
            }
        }
        let candidates = pairs.iter().filter(|pair| pair[0] != TOMBSTONE);
        assert_eq!(count, 2 * candidates.count(), "a candidate is in no list");
    }
}
